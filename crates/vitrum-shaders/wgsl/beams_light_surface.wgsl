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
struct type_13 {
member: array<f32>,
}
struct type_17 {
member: u32,
member_1: u32,
}
struct type_18 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_20 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_21 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_22 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_23 {
member: type_2,
member_1: type_17,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_21,
member_19: type_22,
}
struct type_24 {
member: type_23,
}
struct type_25 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
}
struct type_27 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_24;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_13;
@group(0) @binding(3)
var<storage> global_4: type_13;
@group(0) @binding(7)
var<storage, read_write> global_5: type_13;
@group(0) @binding(4)
var<storage> global_6: type_13;
@group(0) @binding(5)
var<storage> global_7: type_13;
@group(0) @binding(6)
var<storage> global_8: type_13;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: f32;
var local_5: i32;
var local_6: f32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: u32;
var local_12: type_17;
var local_13: u32;
var local_14: u32;
var local_15: type_17;
var local_16: u32;
var local_17: type_25;
var local_18: i32;
var local_19: i32;
var phi_2475_: type_27;
var phi_2539_: bool;
var phi_2571_: f32;
var phi_2651_: u32;
var phi_2652_: u32;
var phi_2664_: u32;
var phi_2665_: u32;
var local_20: u32;
var local_21: u32;
var phi_2682_: u32;
var phi_2683_: u32;
var phi_2695_: u32;
var phi_2696_: u32;
var local_22: u32;
var local_23: u32;
var local_24: u32;
var phi_2721_: u32;
var phi_2722_: u32;
var local_25: u32;
var local_26: u32;
var phi_2739_: u32;
var phi_2740_: u32;
var local_27: u32;
var local_28: u32;
var phi_2762_: u32;
var phi_2763_: u32;
var phi_2775_: u32;
var phi_2776_: u32;
var local_29: u32;
var local_30: u32;
var local_31: u32;
var phi_2812_: u32;
var local_32: u32;
var phi_2825_: vec3<f32>;
var phi_2828_: type_17;
var phi_3087_: u32;
var phi_3104_: u32;
var phi_3107_: u32;
var phi_3126_: u32;
var phi_3105_: u32;
var phi_3108_: u32;
var phi_3416_: u32;
var phi_3418_: vec3<f32>;
var phi_3421_: u32;
var phi_3450_: u32;
var phi_3496_: i32;
var phi_5375_: f32;
var phi_5376_: f32;
var phi_5399_: u32;
var phi_5402_: f32;
var phi_5537_: i32;
var phi_5550_: i32;
var phi_5564_: i32;
var phi_5880_: i32;
var phi_5893_: i32;
var phi_5907_: i32;
var phi_5400_: u32;
var phi_5403_: f32;
var phi_6112_: f32;
var phi_6445_: vec3<f32>;
var phi_6446_: vec3<f32>;
var phi_6447_: bool;
var phi_6451_: vec3<f32>;
var phi_6452_: bool;
var phi_6468_: vec3<f32>;
var phi_3419_: vec3<f32>;
var phi_3422_: u32;
var phi_6478_: type_17;
var phi_6479_: type_17;
var phi_6500_: vec3<f32>;
var phi_6501_: type_17;
var phi_2826_: vec3<f32>;
var phi_2829_: type_17;
var phi_6649_: u32;
var phi_6652_: f32;
var phi_6787_: i32;
var phi_6800_: i32;
var phi_6814_: i32;
var phi_7130_: i32;
var phi_7143_: i32;
var phi_7157_: i32;
var phi_6650_: u32;
var phi_6653_: f32;
var phi_7362_: f32;
var local_33: vec3<f32>;
var local_34: vec3<f32>;
var local_35: vec3<f32>;
var phi_7601_: array<f32, 22>;
var local_36: u32;
var local_37: f32;
var local_38: vec3<f32>;
var local_39: type_17;
var local_40: f32;
let _e130 = global;
let _e141 = arrayLength((&global_6.member));
let _e151 = global_1.member.member;
if (_e130.x < _e151.member) {
if (_e130.y < _e151.member_1) {
let _e158 = (_e151.member * _e151.member_1);
let _e160 = ((_e130.y * _e151.member) + _e130.x);
let _e161 = bitcast<i32>(_e160);
let _e163 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e165 = select(_e163, _e161, (_e161 < _e163));
let _e171 = global_5.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e172 = (_e158 + _e160);
let _e173 = bitcast<i32>(_e172);
let _e175 = select(_e163, _e173, (_e173 < _e163));
let _e181 = global_5.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e183 = ((2u * _e158) + _e160);
let _e184 = bitcast<i32>(_e183);
let _e186 = select(_e163, _e184, (_e184 < _e163));
let _e192 = global_5.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e194 = ((3u * _e158) + _e160);
let _e195 = bitcast<i32>(_e194);
let _e197 = select(_e163, _e195, (_e195 < _e163));
let _e203 = global_5.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e205 = ((4u * _e158) + _e160);
let _e206 = bitcast<i32>(_e205);
let _e208 = select(_e163, _e206, (_e206 < _e163));
let _e214 = global_5.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e216 = ((5u * _e158) + _e160);
let _e217 = bitcast<i32>(_e216);
let _e219 = select(_e163, _e217, (_e217 < _e163));
let _e225 = global_5.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e227 = ((6u * _e158) + _e160);
let _e228 = bitcast<i32>(_e227);
let _e230 = select(_e163, _e228, (_e228 < _e163));
let _e236 = global_5.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e238 = ((7u * _e158) + _e160);
let _e239 = bitcast<i32>(_e238);
let _e241 = select(_e163, _e239, (_e239 < _e163));
let _e247 = global_5.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e249 = ((8u * _e158) + _e160);
let _e250 = bitcast<i32>(_e249);
let _e252 = select(_e163, _e250, (_e250 < _e163));
let _e258 = global_5.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e260 = ((9u * _e158) + _e160);
let _e261 = bitcast<i32>(_e260);
let _e263 = select(_e163, _e261, (_e261 < _e163));
let _e269 = global_5.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e271 = ((10u * _e158) + _e160);
let _e272 = bitcast<i32>(_e271);
let _e274 = select(_e163, _e272, (_e272 < _e163));
let _e280 = global_5.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e282 = ((11u * _e158) + _e160);
let _e283 = bitcast<i32>(_e282);
let _e285 = select(_e163, _e283, (_e283 < _e163));
let _e291 = global_5.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e293 = ((12u * _e158) + _e160);
let _e294 = bitcast<i32>(_e293);
let _e296 = select(_e163, _e294, (_e294 < _e163));
let _e302 = global_5.member[bitcast<u32>(select(0i, _e296, (_e296 > 0i)))];
let _e304 = ((13u * _e158) + _e160);
let _e305 = bitcast<i32>(_e304);
let _e307 = select(_e163, _e305, (_e305 < _e163));
let _e313 = global_5.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e315 = ((14u * _e158) + _e160);
let _e316 = bitcast<i32>(_e315);
let _e318 = select(_e163, _e316, (_e316 < _e163));
let _e324 = global_5.member[bitcast<u32>(select(0i, _e318, (_e318 > 0i)))];
let _e326 = ((15u * _e158) + _e160);
let _e327 = bitcast<i32>(_e326);
let _e329 = select(_e163, _e327, (_e327 < _e163));
let _e335 = global_5.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e337 = ((16u * _e158) + _e160);
let _e338 = bitcast<i32>(_e337);
let _e340 = select(_e163, _e338, (_e338 < _e163));
let _e346 = global_5.member[bitcast<u32>(select(0i, _e340, (_e340 > 0i)))];
let _e348 = ((17u * _e158) + _e160);
let _e349 = bitcast<i32>(_e348);
let _e351 = select(_e163, _e349, (_e349 < _e163));
let _e357 = global_5.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
let _e359 = ((18u * _e158) + _e160);
let _e360 = bitcast<i32>(_e359);
let _e362 = select(_e163, _e360, (_e360 < _e163));
let _e368 = global_5.member[bitcast<u32>(select(0i, _e362, (_e362 > 0i)))];
let _e370 = ((19u * _e158) + _e160);
let _e371 = bitcast<i32>(_e370);
let _e373 = select(_e163, _e371, (_e371 < _e163));
let _e379 = global_5.member[bitcast<u32>(select(0i, _e373, (_e373 > 0i)))];
let _e381 = ((20u * _e158) + _e160);
let _e382 = bitcast<i32>(_e381);
let _e384 = select(_e163, _e382, (_e382 < _e163));
let _e390 = global_5.member[bitcast<u32>(select(0i, _e384, (_e384 > 0i)))];
let _e392 = ((21u * _e158) + _e160);
let _e393 = bitcast<i32>(_e392);
let _e395 = select(_e163, _e393, (_e393 < _e163));
let _e401 = global_5.member[bitcast<u32>(select(0i, _e395, (_e395 > 0i)))];
let _e406 = global_1.member.member.member;
let _e410 = global_1.member.member.member_1;
let _e411 = (_e406 * _e410);
local_18 = bitcast<i32>(_e411);
let _e414 = ((_e130.y * _e406) + _e130.x);
let _e415 = bitcast<i32>(_e414);
local_19 = _e415;
let _e416 = local_18;
let _e418 = local_19;
let _e419 = ((29i * _e416) + _e418);
let _e421 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e423 = select(_e421, _e419, (_e419 < _e421));
let _e428 = global_2.member[bitcast<u32>(select(0i, _e423, (_e423 > 0i)))];
let _e430 = local_18;
let _e432 = local_19;
let _e433 = ((36i * _e430) + _e432);
let _e435 = select(_e421, _e433, (_e433 < _e421));
let _e440 = global_2.member[bitcast<u32>(select(0i, _e435, (_e435 > 0i)))];
let _e451 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e428 == 2f) && (select(0i, select(select(i32(_e440), i32(-2147483648), (_e440 < -2147483600f)), 2147483647i, (_e440 > 2147483500f)), (_e440 == _e440)) == (bitcast<i32>(_e451) + 1i)))) > 1u) {
let _e459 = select(_e421, _e415, (_e415 < _e421));
let _e465 = global_2.member[bitcast<u32>(select(0i, _e459, (_e459 > 0i)))];
let _e467 = bitcast<i32>((_e411 + _e414));
let _e469 = select(_e421, _e467, (_e467 < _e421));
let _e475 = global_2.member[bitcast<u32>(select(0i, _e469, (_e469 > 0i)))];
let _e478 = bitcast<i32>(((2u * _e411) + _e414));
let _e480 = select(_e421, _e478, (_e478 < _e421));
let _e486 = global_2.member[bitcast<u32>(select(0i, _e480, (_e480 > 0i)))];
let _e489 = bitcast<i32>(((3u * _e411) + _e414));
let _e491 = select(_e421, _e489, (_e489 < _e421));
let _e497 = global_2.member[bitcast<u32>(select(0i, _e491, (_e491 > 0i)))];
let _e500 = bitcast<i32>(((4u * _e411) + _e414));
let _e502 = select(_e421, _e500, (_e500 < _e421));
let _e508 = global_2.member[bitcast<u32>(select(0i, _e502, (_e502 > 0i)))];
let _e511 = bitcast<i32>(((5u * _e411) + _e414));
let _e513 = select(_e421, _e511, (_e511 < _e421));
let _e519 = global_2.member[bitcast<u32>(select(0i, _e513, (_e513 > 0i)))];
let _e522 = bitcast<i32>(((6u * _e411) + _e414));
let _e524 = select(_e421, _e522, (_e522 < _e421));
let _e530 = global_2.member[bitcast<u32>(select(0i, _e524, (_e524 > 0i)))];
let _e533 = bitcast<i32>(((7u * _e411) + _e414));
let _e535 = select(_e421, _e533, (_e533 < _e421));
let _e541 = global_2.member[bitcast<u32>(select(0i, _e535, (_e535 > 0i)))];
let _e544 = bitcast<i32>(((8u * _e411) + _e414));
let _e546 = select(_e421, _e544, (_e544 < _e421));
let _e552 = global_2.member[bitcast<u32>(select(0i, _e546, (_e546 > 0i)))];
let _e555 = bitcast<i32>(((9u * _e411) + _e414));
let _e557 = select(_e421, _e555, (_e555 < _e421));
let _e563 = global_2.member[bitcast<u32>(select(0i, _e557, (_e557 > 0i)))];
let _e566 = bitcast<i32>(((10u * _e411) + _e414));
let _e568 = select(_e421, _e566, (_e566 < _e421));
let _e574 = global_2.member[bitcast<u32>(select(0i, _e568, (_e568 > 0i)))];
let _e577 = bitcast<i32>(((11u * _e411) + _e414));
let _e579 = select(_e421, _e577, (_e577 < _e421));
let _e585 = global_2.member[bitcast<u32>(select(0i, _e579, (_e579 > 0i)))];
let _e588 = bitcast<i32>(((12u * _e411) + _e414));
let _e590 = select(_e421, _e588, (_e588 < _e421));
let _e596 = global_2.member[bitcast<u32>(select(0i, _e590, (_e590 > 0i)))];
let _e599 = bitcast<i32>(((13u * _e411) + _e414));
let _e601 = select(_e421, _e599, (_e599 < _e421));
let _e607 = global_2.member[bitcast<u32>(select(0i, _e601, (_e601 > 0i)))];
let _e610 = bitcast<i32>(((14u * _e411) + _e414));
let _e612 = select(_e421, _e610, (_e610 < _e421));
let _e618 = global_2.member[bitcast<u32>(select(0i, _e612, (_e612 > 0i)))];
let _e621 = bitcast<i32>(((15u * _e411) + _e414));
let _e623 = select(_e421, _e621, (_e621 < _e421));
let _e629 = global_2.member[bitcast<u32>(select(0i, _e623, (_e623 > 0i)))];
let _e632 = bitcast<i32>(((16u * _e411) + _e414));
let _e634 = select(_e421, _e632, (_e632 < _e421));
let _e640 = global_2.member[bitcast<u32>(select(0i, _e634, (_e634 > 0i)))];
let _e643 = bitcast<i32>(((17u * _e411) + _e414));
let _e645 = select(_e421, _e643, (_e643 < _e421));
let _e651 = global_2.member[bitcast<u32>(select(0i, _e645, (_e645 > 0i)))];
let _e654 = bitcast<i32>(((18u * _e411) + _e414));
let _e656 = select(_e421, _e654, (_e654 < _e421));
let _e662 = global_2.member[bitcast<u32>(select(0i, _e656, (_e656 > 0i)))];
let _e665 = bitcast<i32>(((19u * _e411) + _e414));
let _e667 = select(_e421, _e665, (_e665 < _e421));
let _e673 = global_2.member[bitcast<u32>(select(0i, _e667, (_e667 > 0i)))];
let _e676 = bitcast<i32>(((20u * _e411) + _e414));
let _e678 = select(_e421, _e676, (_e676 < _e421));
let _e684 = global_2.member[bitcast<u32>(select(0i, _e678, (_e678 > 0i)))];
let _e687 = bitcast<i32>(((23u * _e411) + _e414));
let _e689 = select(_e421, _e687, (_e687 < _e421));
let _e695 = global_2.member[bitcast<u32>(select(0i, _e689, (_e689 > 0i)))];
let _e698 = bitcast<i32>(((24u * _e411) + _e414));
let _e700 = select(_e421, _e698, (_e698 < _e421));
let _e706 = global_2.member[bitcast<u32>(select(0i, _e700, (_e700 > 0i)))];
let _e709 = bitcast<i32>(((30u * _e411) + _e414));
let _e711 = select(_e421, _e709, (_e709 < _e421));
let _e717 = global_2.member[bitcast<u32>(select(0i, _e711, (_e711 > 0i)))];
let _e724 = select(0i, select(select(i32(_e695), i32(-2147483648), (_e695 < -2147483600f)), 2147483647i, (_e695 > 2147483500f)), (_e695 == _e695));
let _e732 = (select(0i, select(select(i32(_e717), i32(-2147483648), (_e717 < -2147483600f)), 2147483647i, (_e717 > 2147483500f)), (_e717 == _e717)) == 0i);
let _e740 = global_1.member.member_1.member;
let _e746 = global_1.member.member_1.member_1;
let _e756 = global_1.member.member_2.member;
let _e757 = (((((f32(bitcast<i32>(_e130.x)) + 0.5f) / f32(bitcast<i32>(_e740))) * 2f) - 1f) * _e756);
let _e765 = global_1.member.member_2.member_1;
let _e766 = ((1f - (((f32(bitcast<i32>(_e130.y)) + 0.5f) / f32(bitcast<i32>(_e746))) * 2f)) * _e765);
let _e769 = global_1.member.member_3;
let _e778 = global_1.member.member_4;
let _e791 = global_1.member.member_2.member_3;
let _e792 = (_e791 != 0u);
let _e795 = global_1.member.member_6;
let _e802 = select(_e795.member, (_e795.member + ((_e769.member * _e757) + (_e778.member * _e766))), _e792);
let _e803 = select(_e795.member_1, (_e795.member_1 + ((_e769.member_1 * _e757) + (_e778.member_1 * _e766))), _e792);
let _e804 = select(_e795.member_2, (_e795.member_2 + ((_e769.member_2 * _e757) + (_e778.member_2 * _e766))), _e792);
let _e814 = select(_e465, _e802, _e732);
let _e815 = select(_e475, _e803, _e732);
let _e816 = select(_e486, _e804, _e732);
let _e817 = (select(0f, ((((_e465 - _e802) * _e497) + ((_e475 - _e803) * _e508)) + ((_e486 - _e804) * _e519)), _e732) + _e706);
let _e822 = select(_e817, 0f, (_e724 == -1i));
let _e826 = (_e814 + (_e497 * _e822));
let _e827 = (_e815 + (_e508 * _e822));
let _e828 = (_e816 + (_e519 * _e822));
let _e829 = vec3<f32>(_e826, _e827, _e828);
let _e832 = global_1.member.member_17;
let _e835 = (_e724 >= 0i);
if _e835 {
let _e880 = (_e724 * 19i);
let _e882 = (bitcast<i32>(_e141) - 1i);
let _e884 = select(_e882, _e880, (_e880 < _e882));
let _e890 = global_6.member[bitcast<u32>(select(0i, _e884, (_e884 > 0i)))];
let _e891 = (_e880 + 1i);
let _e893 = select(_e882, _e891, (_e891 < _e882));
let _e899 = global_6.member[bitcast<u32>(select(0i, _e893, (_e893 > 0i)))];
let _e900 = (_e880 + 2i);
let _e902 = select(_e882, _e900, (_e900 < _e882));
let _e908 = global_6.member[bitcast<u32>(select(0i, _e902, (_e902 > 0i)))];
let _e909 = (_e880 + 3i);
let _e911 = select(_e882, _e909, (_e909 < _e882));
let _e917 = global_6.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e918 = (_e880 + 4i);
let _e920 = select(_e882, _e918, (_e918 < _e882));
let _e926 = global_6.member[bitcast<u32>(select(0i, _e920, (_e920 > 0i)))];
let _e927 = (_e880 + 5i);
let _e929 = select(_e882, _e927, (_e927 < _e882));
let _e935 = global_6.member[bitcast<u32>(select(0i, _e929, (_e929 > 0i)))];
let _e936 = (_e880 + 6i);
let _e938 = select(_e882, _e936, (_e936 < _e882));
let _e944 = global_6.member[bitcast<u32>(select(0i, _e938, (_e938 > 0i)))];
let _e945 = (_e880 + 7i);
let _e947 = select(_e882, _e945, (_e945 < _e882));
let _e953 = global_6.member[bitcast<u32>(select(0i, _e947, (_e947 > 0i)))];
let _e954 = (_e880 + 8i);
let _e956 = select(_e882, _e954, (_e954 < _e882));
let _e962 = global_6.member[bitcast<u32>(select(0i, _e956, (_e956 > 0i)))];
let _e963 = (_e917 - _e890);
let _e964 = (_e926 - _e899);
let _e965 = (_e935 - _e908);
let _e966 = (_e944 - _e890);
let _e967 = (_e953 - _e899);
let _e968 = (_e962 - _e908);
let _e971 = ((_e964 * _e968) - (_e965 * _e967));
let _e974 = ((_e965 * _e966) - (_e963 * _e968));
let _e977 = ((_e963 * _e967) - (_e964 * _e966));
let _e978 = (_e917 - _e826);
let _e979 = (_e926 - _e827);
let _e980 = (_e935 - _e828);
let _e981 = (_e944 - _e826);
let _e982 = (_e953 - _e827);
let _e983 = (_e962 - _e828);
let _e997 = (((((_e979 * _e983) - (_e980 * _e982)) * _e971) + (((_e980 * _e981) - (_e978 * _e983)) * _e974)) + (((_e978 * _e982) - (_e979 * _e981)) * _e977));
let _e999 = select(0f, _e997, (_e997 > 0f));
let _e1000 = (_e890 - _e826);
let _e1001 = (_e899 - _e827);
let _e1002 = (_e908 - _e828);
let _e1016 = (((((_e982 * _e1002) - (_e983 * _e1001)) * _e971) + (((_e983 * _e1000) - (_e981 * _e1002)) * _e974)) + (((_e981 * _e1001) - (_e982 * _e1000)) * _e977));
let _e1018 = select(0f, _e1016, (_e1016 > 0f));
let _e1032 = (((((_e1001 * _e980) - (_e1002 * _e979)) * _e971) + (((_e1002 * _e978) - (_e1000 * _e980)) * _e974)) + (((_e1000 * _e979) - (_e1001 * _e978)) * _e977));
let _e1034 = select(0f, _e1032, (_e1032 > 0f));
let _e1036 = ((_e999 + _e1018) + _e1034);
let _e1038 = select(1e-30f, _e1036, (_e1036 > 1e-30f));
let _e1039 = (_e999 / _e1038);
let _e1040 = (_e1018 / _e1038);
let _e1041 = (_e1034 / _e1038);
let _e1046 = (((_e971 * _e971) + (_e974 * _e974)) + (_e977 * _e977));
let _e1049 = sqrt(select(0f, _e1046, (_e1046 > 0f)));
let _e1052 = (1f / select(1e-20f, _e1049, (_e1049 > 1e-20f)));
let _e1057 = (_e880 + 9i);
let _e1059 = select(_e882, _e1057, (_e1057 < _e882));
let _e1065 = global_6.member[bitcast<u32>(select(0i, _e1059, (_e1059 > 0i)))];
let _e1066 = (_e880 + 10i);
let _e1068 = select(_e882, _e1066, (_e1066 < _e882));
let _e1074 = global_6.member[bitcast<u32>(select(0i, _e1068, (_e1068 > 0i)))];
let _e1075 = (_e880 + 11i);
let _e1077 = select(_e882, _e1075, (_e1075 < _e882));
let _e1083 = global_6.member[bitcast<u32>(select(0i, _e1077, (_e1077 > 0i)))];
let _e1087 = (_e880 + 12i);
let _e1089 = select(_e882, _e1087, (_e1087 < _e882));
let _e1095 = global_6.member[bitcast<u32>(select(0i, _e1089, (_e1089 > 0i)))];
let _e1096 = (_e880 + 13i);
let _e1098 = select(_e882, _e1096, (_e1096 < _e882));
let _e1104 = global_6.member[bitcast<u32>(select(0i, _e1098, (_e1098 > 0i)))];
let _e1105 = (_e880 + 14i);
let _e1107 = select(_e882, _e1105, (_e1105 < _e882));
let _e1113 = global_6.member[bitcast<u32>(select(0i, _e1107, (_e1107 > 0i)))];
let _e1120 = (_e880 + 15i);
let _e1122 = select(_e882, _e1120, (_e1120 < _e882));
let _e1128 = global_6.member[bitcast<u32>(select(0i, _e1122, (_e1122 > 0i)))];
let _e1129 = (_e880 + 16i);
let _e1131 = select(_e882, _e1129, (_e1129 < _e882));
let _e1137 = global_6.member[bitcast<u32>(select(0i, _e1131, (_e1131 > 0i)))];
let _e1138 = (_e880 + 17i);
let _e1140 = select(_e882, _e1138, (_e1138 < _e882));
let _e1146 = global_6.member[bitcast<u32>(select(0i, _e1140, (_e1140 > 0i)))];
let _e1150 = (((_e1065 * _e1039) + (_e1095 * _e1040)) + (_e1128 * _e1041));
let _e1151 = (((_e1074 * _e1039) + (_e1104 * _e1040)) + (_e1137 * _e1041));
let _e1152 = (((_e1083 * _e1039) + (_e1113 * _e1040)) + (_e1146 * _e1041));
let _e1157 = (((_e1150 * _e1150) + (_e1151 * _e1151)) + (_e1152 * _e1152));
let _e1160 = sqrt(select(0f, _e1157, (_e1157 > 0f)));
let _e1163 = (1f / select(1e-20f, _e1160, (_e1160 > 1e-20f)));
let _e1168 = (_e880 + 18i);
let _e1170 = select(_e882, _e1168, (_e1168 < _e882));
let _e1176 = global_6.member[bitcast<u32>(select(0i, _e1170, (_e1170 > 0i)))];
let _e1185 = (select(select(0i, select(select(i32(_e1176), i32(-2147483648), (_e1176 < -2147483600f)), 2147483647i, (_e1176 > 2147483500f)), (_e1176 == _e1176)), _e724, ((_e832 & 1u) != 0u)) * 10i);
let _e1187 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1189 = select(_e1187, _e1185, (_e1185 < _e1187));
let _e1195 = global_7.member[bitcast<u32>(select(0i, _e1189, (_e1189 > 0i)))];
let _e1196 = (_e1185 + 1i);
let _e1198 = select(_e1187, _e1196, (_e1196 < _e1187));
let _e1204 = global_7.member[bitcast<u32>(select(0i, _e1198, (_e1198 > 0i)))];
let _e1205 = (_e1185 + 2i);
let _e1207 = select(_e1187, _e1205, (_e1205 < _e1187));
let _e1213 = global_7.member[bitcast<u32>(select(0i, _e1207, (_e1207 > 0i)))];
let _e1217 = (_e1185 + 3i);
let _e1219 = select(_e1187, _e1217, (_e1217 < _e1187));
let _e1225 = global_7.member[bitcast<u32>(select(0i, _e1219, (_e1219 > 0i)))];
let _e1226 = (_e1185 + 4i);
let _e1228 = select(_e1187, _e1226, (_e1226 < _e1187));
let _e1234 = global_7.member[bitcast<u32>(select(0i, _e1228, (_e1228 > 0i)))];
let _e1235 = (_e1185 + 5i);
let _e1237 = select(_e1187, _e1235, (_e1235 < _e1187));
let _e1243 = global_7.member[bitcast<u32>(select(0i, _e1237, (_e1237 > 0i)))];
let _e1250 = (_e1185 + 6i);
let _e1252 = select(_e1187, _e1250, (_e1250 < _e1187));
let _e1258 = global_7.member[bitcast<u32>(select(0i, _e1252, (_e1252 > 0i)))];
let _e1259 = (_e1185 + 7i);
let _e1261 = select(_e1187, _e1259, (_e1259 < _e1187));
let _e1267 = global_7.member[bitcast<u32>(select(0i, _e1261, (_e1261 > 0i)))];
let _e1268 = (_e1185 + 8i);
let _e1270 = select(_e1187, _e1268, (_e1268 < _e1187));
let _e1276 = global_7.member[bitcast<u32>(select(0i, _e1270, (_e1270 > 0i)))];
let _e1284 = (_e1185 + 9i);
let _e1286 = select(_e1187, _e1284, (_e1284 < _e1187));
let _e1292 = global_7.member[bitcast<u32>(select(0i, _e1286, (_e1286 > 0i)))];
phi_2475_ = type_27(_e829, vec3<f32>((_e971 * _e1052), (_e974 * _e1052), (_e977 * _e1052)), vec3<f32>((_e1150 * _e1163), (_e1151 * _e1163), (_e1152 * _e1163)), vec3<f32>((((_e1195 * _e1039) + (_e1225 * _e1040)) + (_e1258 * _e1041)), (((_e1204 * _e1039) + (_e1234 * _e1040)) + (_e1267 * _e1041)), (((_e1213 * _e1039) + (_e1243 * _e1040)) + (_e1276 * _e1041))), _e1292, true);
} else {
let _e836 = (_e724 == -3i);
let _e842 = global_1.member.member_14.member_1.member.member;
let _e847 = global_1.member.member_14.member_1.member_1;
let _e853 = global_1.member.member_14.member.member.member;
let _e858 = global_1.member.member_14.member.member_1;
let _e868 = vec3<f32>(select(_e853.member, _e842.member, _e836), select(_e853.member_1, _e842.member_1, _e836), select(_e853.member_2, _e842.member_2, _e836));
phi_2475_ = type_27(_e829, _e868, _e868, vec3<f32>(select(_e858.member, _e847.member, _e836), select(_e858.member_1, _e847.member_1, _e836), select(_e858.member_2, _e847.member_2, _e836)), 0f, false);
}
let _e1295 = phi_2475_;
let _e1298 = ((select(0i, _e724, _e835) * 19i) + 18i);
let _e1300 = (bitcast<i32>(_e141) - 1i);
let _e1302 = select(_e1300, _e1298, (_e1298 < _e1300));
let _e1308 = global_6.member[bitcast<u32>(select(0i, _e1302, (_e1302 > 0i)))];
let _e1315 = select(0i, select(select(i32(_e1308), i32(-2147483648), (_e1308 < -2147483600f)), 2147483647i, (_e1308 > 2147483500f)), (_e1308 == _e1308));
let _e1316 = (_e1315 * 4i);
let _e1318 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e1320 = select(_e1318, _e1316, (_e1316 < _e1318));
let _e1326 = global_8.member[bitcast<u32>(select(0i, _e1320, (_e1320 > 0i)))];
if _e835 {
phi_2539_ = (select(_e1326, 1f, (_e1315 == 16i)) == 0f);
} else {
phi_2539_ = (_e724 != -1i);
}
let _e1332 = phi_2539_;
if _e1332 {
let _e1336 = (_e530 + (_e596 * _e706));
let _e1337 = (_e541 + (_e607 * _e706));
let _e1338 = (_e552 + (_e618 * _e706));
let _e1342 = (_e563 + (_e629 * _e706));
let _e1343 = (_e574 + (_e640 * _e706));
let _e1344 = (_e585 + (_e651 * _e706));
let _e1353 = (((_e497 * _e1295.member_1.x) + (_e508 * _e1295.member_1.y)) + (_e519 * _e1295.member_1.z));
if ((_e1353 * _e1353) > 1e-12f) {
phi_2571_ = (1f / _e1353);
} else {
phi_2571_ = 0f;
}
let _e1358 = phi_2571_;
let _e1364 = ((((_e1336 * _e1295.member_1.x) + (_e1337 * _e1295.member_1.y)) + (_e1338 * _e1295.member_1.z)) * _e1358);
let _e1368 = (_e1336 - (_e497 * _e1364));
let _e1369 = (_e1337 - (_e508 * _e1364));
let _e1370 = (_e1338 - (_e519 * _e1364));
let _e1376 = ((((_e1342 * _e1295.member_1.x) + (_e1343 * _e1295.member_1.y)) + (_e1344 * _e1295.member_1.z)) * _e1358);
let _e1380 = (_e1342 - (_e497 * _e1376));
let _e1381 = (_e1343 - (_e508 * _e1376));
let _e1382 = (_e1344 - (_e519 * _e1376));
let _e1387 = (((_e1368 * _e1368) + (_e1369 * _e1369)) + (_e1370 * _e1370));
let _e1395 = (((_e1380 * _e1380) + (_e1381 * _e1381)) + (_e1382 * _e1382));
let _e1401 = (0.05f + (0.5f * (sqrt(select(0f, _e1387, (_e1387 > 0f))) + sqrt(select(0f, _e1395, (_e1395 > 0f))))));
let _e1405 = global_1.member.member_11.member;
let _e1411 = global_1.member.member_12.member_5;
let _e1415 = global_1.member.member_12.member_6;
phi_2651_ = 0u;
loop {
let _e1419 = phi_2651_;
local_32 = _e1419;
let _e1423 = ((1u << bitcast<u32>((_e1419 & 31u))) < _e1405);
if _e1423 {
phi_2652_ = (_e1419 + 1u);
} else {
phi_2652_ = u32();
}
let _e1426 = phi_2652_;
continue;
continuing {
phi_2651_ = _e1426;
break if !(_e1423);
}
}
phi_2664_ = 0u;
loop {
let _e1429 = phi_2664_;
local_20 = _e1429;
local_21 = _e1429;
let _e1433 = ((1u << bitcast<u32>((_e1429 & 31u))) < _e1405);
if _e1433 {
phi_2665_ = (_e1429 + 1u);
} else {
phi_2665_ = u32();
}
let _e1436 = phi_2665_;
continue;
continuing {
phi_2664_ = _e1436;
break if !(_e1433);
}
}
let _e1439 = local_20;
let _e1442 = local_21;
phi_2682_ = 0u;
loop {
let _e1445 = phi_2682_;
local_24 = _e1445;
let _e1449 = ((1u << bitcast<u32>((_e1445 & 31u))) < _e1405);
if _e1449 {
phi_2683_ = (_e1445 + 1u);
} else {
phi_2683_ = u32();
}
let _e1452 = phi_2683_;
continue;
continuing {
phi_2682_ = _e1452;
break if !(_e1449);
}
}
phi_2695_ = 0u;
loop {
let _e1455 = phi_2695_;
local_22 = _e1455;
local_23 = _e1455;
let _e1459 = ((1u << bitcast<u32>((_e1455 & 31u))) < _e1405);
if _e1459 {
phi_2696_ = (_e1455 + 1u);
} else {
phi_2696_ = u32();
}
let _e1462 = phi_2696_;
continue;
continuing {
phi_2695_ = _e1462;
break if !(_e1459);
}
}
let _e1465 = local_22;
let _e1468 = local_23;
let _e1471 = local_24;
let _e1480 = global_1.member.member_12.member_8;
phi_2721_ = 0u;
loop {
let _e1483 = phi_2721_;
local_25 = _e1483;
local_26 = _e1483;
let _e1487 = ((1u << bitcast<u32>((_e1483 & 31u))) < _e1405);
if _e1487 {
phi_2722_ = (_e1483 + 1u);
} else {
phi_2722_ = u32();
}
let _e1490 = phi_2722_;
continue;
continuing {
phi_2721_ = _e1490;
break if !(_e1487);
}
}
let _e1493 = local_25;
let _e1496 = local_26;
phi_2739_ = 0u;
loop {
let _e1499 = phi_2739_;
local_27 = _e1499;
local_28 = _e1499;
let _e1503 = ((1u << bitcast<u32>((_e1499 & 31u))) < _e1405);
if _e1503 {
phi_2740_ = (_e1499 + 1u);
} else {
phi_2740_ = u32();
}
let _e1506 = phi_2740_;
continue;
continuing {
phi_2739_ = _e1506;
break if !(_e1503);
}
}
let _e1509 = local_27;
let _e1515 = local_28;
phi_2762_ = 0u;
loop {
let _e1525 = phi_2762_;
local_31 = _e1525;
let _e1529 = ((1u << bitcast<u32>((_e1525 & 31u))) < _e1405);
if _e1529 {
phi_2763_ = (_e1525 + 1u);
} else {
phi_2763_ = u32();
}
let _e1532 = phi_2763_;
continue;
continuing {
phi_2762_ = _e1532;
break if !(_e1529);
}
}
phi_2775_ = 0u;
loop {
let _e1535 = phi_2775_;
local_29 = _e1535;
local_30 = _e1535;
let _e1539 = ((1u << bitcast<u32>((_e1535 & 31u))) < _e1405);
if _e1539 {
phi_2776_ = (_e1535 + 1u);
} else {
phi_2776_ = u32();
}
let _e1542 = phi_2776_;
continue;
continuing {
phi_2775_ = _e1542;
break if !(_e1539);
}
}
let _e1545 = local_29;
let _e1548 = local_30;
let _e1551 = local_31;
let _e1557 = (((((1u << bitcast<u32>(((2u * _e1509) & 31u))) - (1u << bitcast<u32>(((2u * (_e1515 - select(6u, _e1496, (_e1493 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1551 - select(6u, _e1548, (_e1545 < 6u)))) & 31u))));
let _e1558 = (_e1557 / 64u);
if ((_e1557 % 64u) > 0u) {
phi_2812_ = (_e1558 + 1u);
} else {
phi_2812_ = _e1558;
}
let _e1563 = phi_2812_;
let _e1566 = local_32;
local_17 = type_25(_e1566, select(6u, _e1442, (_e1439 < 6u)), (1u << bitcast<u32>(((2u * (_e1471 - select(6u, _e1468, (_e1465 < 6u)))) & 31u))), (_e1411 * _e1480), (_e1563 * 64u));
let _e1569 = local_17.member_1;
phi_2825_ = vec3<f32>(0f, 0f, 0f);
phi_2828_ = type_17(_e1569, 0u);
loop {
let _e1572 = phi_2825_;
let _e1574 = phi_2828_;
local_33 = _e1572;
local_34 = _e1572;
local_35 = _e1572;
let _e1577 = local_17.member_1;
let _e1580 = local_17.member_2;
let _e1582 = ((_e1574.member < _e1577) || (_e1574.member_1 < _e1580));
if _e1582 {
local_15.member = _e1574.member;
local_15.member_1 = _e1574.member_1;
let _e1586 = local_15.member;
let _e1587 = local_15.member_1;
let _e1589 = local_17.member;
let _e1604 = local_17.member_3;
let _e1606 = local_17.member_4;
local_16 = ((_e1604 + (18u * _e1606)) + (((((1u << bitcast<u32>(((2u * _e1589) & 31u))) - (1u << bitcast<u32>(((2u * (_e1589 - _e1586)) & 31u)))) / 3u) * 4u) + _e1587));
let _e1610 = local_16;
let _e1611 = bitcast<i32>(_e1610);
let _e1613 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1615 = select(_e1613, _e1611, (_e1611 < _e1613));
let _e1620 = global_4.member[bitcast<u32>(select(0i, _e1615, (_e1615 > 0i)))];
let _e1621 = local_16;
let _e1622 = local_17.member_4;
let _e1624 = bitcast<i32>((_e1621 + _e1622));
let _e1626 = select(_e1613, _e1624, (_e1624 < _e1613));
let _e1631 = global_4.member[bitcast<u32>(select(0i, _e1626, (_e1626 > 0i)))];
let _e1632 = local_16;
let _e1633 = local_17.member_4;
let _e1636 = bitcast<i32>((_e1632 + (2u * _e1633)));
let _e1638 = select(_e1613, _e1636, (_e1636 < _e1613));
let _e1643 = global_4.member[bitcast<u32>(select(0i, _e1638, (_e1638 > 0i)))];
let _e1644 = local_15.member;
let _e1645 = local_15.member_1;
let _e1646 = local_17.member;
let _e1660 = local_17.member_3;
let _e1661 = local_17.member_4;
local_14 = ((_e1660 + (21u * _e1661)) + (((((1u << bitcast<u32>(((2u * _e1646) & 31u))) - (1u << bitcast<u32>(((2u * (_e1646 - _e1644)) & 31u)))) / 3u) * 4u) + _e1645));
let _e1665 = local_14;
let _e1666 = bitcast<i32>(_e1665);
let _e1668 = select(_e1613, _e1666, (_e1666 < _e1613));
let _e1673 = global_4.member[bitcast<u32>(select(0i, _e1668, (_e1668 > 0i)))];
let _e1674 = local_14;
let _e1675 = local_17.member_4;
let _e1677 = bitcast<i32>((_e1674 + _e1675));
let _e1679 = select(_e1613, _e1677, (_e1677 < _e1613));
let _e1684 = global_4.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1685 = local_14;
let _e1686 = local_17.member_4;
let _e1689 = bitcast<i32>((_e1685 + (2u * _e1686)));
let _e1691 = select(_e1613, _e1689, (_e1689 < _e1613));
let _e1696 = global_4.member[bitcast<u32>(select(0i, _e1691, (_e1691 > 0i)))];
let _e1718 = ((((_e1620 <= _e1673) && ((_e1295.member.x >= (_e1620 - _e1401)) && (_e1295.member.x <= (_e1673 + _e1401)))) && ((_e1295.member.y >= (_e1631 - _e1401)) && (_e1295.member.y <= (_e1684 + _e1401)))) && ((_e1295.member.z >= (_e1643 - _e1401)) && (_e1295.member.z <= (_e1696 + _e1401))));
let _e1719 = local_17.member_1;
if (_e1719 < 2u) {
let _e1721 = local_17.member_1;
phi_3087_ = _e1721;
} else {
phi_3087_ = 2u;
}
let _e1723 = phi_3087_;
if (_e1718 && (_e1574.member > _e1723)) {
phi_6500_ = _e1572;
phi_6501_ = type_17((_e1574.member - 1u), (_e1574.member_1 << bitcast<u32>(2i)));
} else {
if _e1718 {
phi_3104_ = 0u;
phi_3107_ = 0u;
loop {
let _e1727 = phi_3104_;
let _e1729 = phi_3107_;
local_36 = _e1729;
let _e1730 = (_e1727 < 16u);
if _e1730 {
let _e1731 = local_17.member_1;
if (_e1731 < 2u) {
let _e1733 = local_17.member_1;
phi_3126_ = _e1733;
} else {
phi_3126_ = 2u;
}
let _e1735 = phi_3126_;
let _e1737 = ((2u * _e1735) & 31u);
let _e1740 = ((_e1574.member_1 << bitcast<u32>(_e1737)) + _e1727);
let _e1741 = (_e1740 & 1431655765u);
let _e1745 = ((_e1741 | (_e1741 >> bitcast<u32>(1i))) & 858993459u);
let _e1749 = ((_e1745 | (_e1745 >> bitcast<u32>(2i))) & 252645135u);
let _e1753 = ((_e1749 | (_e1749 >> bitcast<u32>(4i))) & 16711935u);
let _e1760 = ((_e1740 >> bitcast<u32>(1i)) & 1431655765u);
let _e1764 = ((_e1760 | (_e1760 >> bitcast<u32>(1i))) & 858993459u);
let _e1768 = ((_e1764 | (_e1764 >> bitcast<u32>(2i))) & 252645135u);
let _e1772 = ((_e1768 | (_e1768 >> bitcast<u32>(4i))) & 16711935u);
local_12.member = 0u;
local_12.member_1 = _e1740;
let _e1786 = local_12.member;
let _e1787 = local_12.member_1;
let _e1788 = local_17.member;
let _e1802 = local_17.member_3;
let _e1803 = local_17.member_4;
local_13 = ((_e1802 + (18u * _e1803)) + (((((1u << bitcast<u32>(((2u * _e1788) & 31u))) - (1u << bitcast<u32>(((2u * (_e1788 - _e1786)) & 31u)))) / 3u) * 4u) + _e1787));
let _e1807 = local_13;
let _e1808 = bitcast<i32>(_e1807);
let _e1810 = select(_e1613, _e1808, (_e1808 < _e1613));
let _e1815 = global_4.member[bitcast<u32>(select(0i, _e1810, (_e1810 > 0i)))];
let _e1816 = local_13;
let _e1817 = local_17.member_4;
let _e1819 = bitcast<i32>((_e1816 + _e1817));
let _e1821 = select(_e1613, _e1819, (_e1819 < _e1613));
let _e1826 = global_4.member[bitcast<u32>(select(0i, _e1821, (_e1821 > 0i)))];
let _e1827 = local_13;
let _e1828 = local_17.member_4;
let _e1831 = bitcast<i32>((_e1827 + (2u * _e1828)));
let _e1833 = select(_e1613, _e1831, (_e1831 < _e1613));
let _e1838 = global_4.member[bitcast<u32>(select(0i, _e1833, (_e1833 > 0i)))];
let _e1839 = local_12.member;
let _e1840 = local_12.member_1;
let _e1841 = local_17.member;
let _e1855 = local_17.member_3;
let _e1856 = local_17.member_4;
local_11 = ((_e1855 + (21u * _e1856)) + (((((1u << bitcast<u32>(((2u * _e1841) & 31u))) - (1u << bitcast<u32>(((2u * (_e1841 - _e1839)) & 31u)))) / 3u) * 4u) + _e1840));
let _e1860 = local_11;
let _e1861 = bitcast<i32>(_e1860);
let _e1863 = select(_e1613, _e1861, (_e1861 < _e1613));
let _e1868 = global_4.member[bitcast<u32>(select(0i, _e1863, (_e1863 > 0i)))];
let _e1869 = local_11;
let _e1870 = local_17.member_4;
let _e1872 = bitcast<i32>((_e1869 + _e1870));
let _e1874 = select(_e1613, _e1872, (_e1872 < _e1613));
let _e1879 = global_4.member[bitcast<u32>(select(0i, _e1874, (_e1874 > 0i)))];
let _e1880 = local_11;
let _e1881 = local_17.member_4;
let _e1884 = bitcast<i32>((_e1880 + (2u * _e1881)));
let _e1886 = select(_e1613, _e1884, (_e1884 < _e1613));
let _e1891 = global_4.member[bitcast<u32>(select(0i, _e1886, (_e1886 > 0i)))];
phi_3105_ = (_e1727 + 1u);
phi_3108_ = (_e1729 | (select(0u, 1u, ((((_e1727 < (1u << bitcast<u32>(_e1737))) && (((_e1753 | (_e1753 >> bitcast<u32>(8i))) & 65535u) < _e1405)) && (((_e1772 | (_e1772 >> bitcast<u32>(8i))) & 65535u) < _e1405)) && ((((_e1815 <= _e1868) && ((_e1295.member.x >= (_e1815 - _e1401)) && (_e1295.member.x <= (_e1868 + _e1401)))) && ((_e1295.member.y >= (_e1826 - _e1401)) && (_e1295.member.y <= (_e1879 + _e1401)))) && ((_e1295.member.z >= (_e1838 - _e1401)) && (_e1295.member.z <= (_e1891 + _e1401)))))) << bitcast<u32>((_e1727 & 31u))));
} else {
phi_3105_ = u32();
phi_3108_ = u32();
}
let _e1919 = phi_3105_;
let _e1921 = phi_3108_;
continue;
continuing {
phi_3104_ = _e1919;
phi_3107_ = _e1921;
break if !(_e1730);
}
}
let _e4722 = local_36;
phi_3416_ = _e4722;
} else {
phi_3416_ = 0u;
}
let _e1924 = phi_3416_;
phi_3418_ = _e1572;
phi_3421_ = 0u;
loop {
let _e1926 = phi_3418_;
let _e1928 = phi_3421_;
local_38 = _e1926;
let _e1931 = (_e1924 >> bitcast<u32>((_e1928 & 31u)));
let _e1932 = (_e1931 == 0u);
if _e1932 {
phi_3419_ = vec3<f32>();
phi_3422_ = u32();
} else {
if ((_e1931 & 1u) == 0u) {
phi_6468_ = _e1926;
} else {
let _e1935 = local_17.member_1;
if (_e1935 < 2u) {
let _e1937 = local_17.member_1;
phi_3450_ = _e1937;
} else {
phi_3450_ = 2u;
}
let _e1939 = phi_3450_;
let _e1941 = ((2u * _e1939) & 31u);
let _e1944 = ((_e1574.member_1 << bitcast<u32>(_e1941)) + _e1928);
let _e1945 = (_e1944 & 1431655765u);
let _e1949 = ((_e1945 | (_e1945 >> bitcast<u32>(1i))) & 858993459u);
let _e1953 = ((_e1949 | (_e1949 >> bitcast<u32>(2i))) & 252645135u);
let _e1957 = ((_e1953 | (_e1953 >> bitcast<u32>(4i))) & 16711935u);
let _e1961 = ((_e1957 | (_e1957 >> bitcast<u32>(8i))) & 65535u);
let _e1964 = ((_e1944 >> bitcast<u32>(1i)) & 1431655765u);
let _e1968 = ((_e1964 | (_e1964 >> bitcast<u32>(1i))) & 858993459u);
let _e1972 = ((_e1968 | (_e1968 >> bitcast<u32>(2i))) & 252645135u);
let _e1976 = ((_e1972 | (_e1972 >> bitcast<u32>(4i))) & 16711935u);
let _e1980 = ((_e1976 | (_e1976 >> bitcast<u32>(8i))) & 65535u);
if (((_e1928 < (1u << bitcast<u32>(_e1941))) && (_e1961 < _e1405)) && (_e1980 < _e1405)) {
phi_3496_ = bitcast<i32>(((_e1980 * _e1405) + _e1961));
} else {
phi_3496_ = 0i;
}
let _e1992 = phi_3496_;
local_8 = bitcast<i32>((_e1411 * _e1415));
local_9 = _e1992;
local_10 = bitcast<i32>((_e1405 * _e1405));
let _e1993 = local_8;
let _e1994 = local_9;
let _e1995 = (_e1993 + _e1994);
let _e1997 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e1999 = select(_e1997, _e1995, (_e1995 < _e1997));
let _e2004 = global_3.member[bitcast<u32>(select(0i, _e1999, (_e1999 > 0i)))];
let _e2005 = local_8;
let _e2006 = local_10;
let _e2008 = local_9;
let _e2009 = ((_e2005 + _e2006) + _e2008);
let _e2011 = select(_e1997, _e2009, (_e2009 < _e1997));
let _e2016 = global_3.member[bitcast<u32>(select(0i, _e2011, (_e2011 > 0i)))];
let _e2017 = local_8;
let _e2018 = local_10;
let _e2021 = local_9;
let _e2022 = ((_e2017 + (2i * _e2018)) + _e2021);
let _e2024 = select(_e1997, _e2022, (_e2022 < _e1997));
let _e2029 = global_3.member[bitcast<u32>(select(0i, _e2024, (_e2024 > 0i)))];
let _e2030 = local_8;
let _e2031 = local_10;
let _e2034 = local_9;
let _e2035 = ((_e2030 + (3i * _e2031)) + _e2034);
let _e2037 = select(_e1997, _e2035, (_e2035 < _e1997));
let _e2042 = global_3.member[bitcast<u32>(select(0i, _e2037, (_e2037 > 0i)))];
let _e2043 = local_8;
let _e2044 = local_10;
let _e2047 = local_9;
let _e2048 = ((_e2043 + (4i * _e2044)) + _e2047);
let _e2050 = select(_e1997, _e2048, (_e2048 < _e1997));
let _e2055 = global_3.member[bitcast<u32>(select(0i, _e2050, (_e2050 > 0i)))];
let _e2056 = local_8;
let _e2057 = local_10;
let _e2060 = local_9;
let _e2061 = ((_e2056 + (5i * _e2057)) + _e2060);
let _e2063 = select(_e1997, _e2061, (_e2061 < _e1997));
let _e2068 = global_3.member[bitcast<u32>(select(0i, _e2063, (_e2063 > 0i)))];
let _e2069 = local_8;
let _e2070 = local_10;
let _e2073 = local_9;
let _e2074 = ((_e2069 + (6i * _e2070)) + _e2073);
let _e2076 = select(_e1997, _e2074, (_e2074 < _e1997));
let _e2081 = global_3.member[bitcast<u32>(select(0i, _e2076, (_e2076 > 0i)))];
let _e2082 = local_8;
let _e2083 = local_10;
let _e2086 = local_9;
let _e2087 = ((_e2082 + (7i * _e2083)) + _e2086);
let _e2089 = select(_e1997, _e2087, (_e2087 < _e1997));
let _e2094 = global_3.member[bitcast<u32>(select(0i, _e2089, (_e2089 > 0i)))];
let _e2095 = local_8;
let _e2096 = local_10;
let _e2099 = local_9;
let _e2100 = ((_e2095 + (8i * _e2096)) + _e2099);
let _e2102 = select(_e1997, _e2100, (_e2100 < _e1997));
let _e2107 = global_3.member[bitcast<u32>(select(0i, _e2102, (_e2102 > 0i)))];
let _e2108 = local_8;
let _e2109 = local_10;
let _e2112 = local_9;
let _e2113 = ((_e2108 + (9i * _e2109)) + _e2112);
let _e2115 = select(_e1997, _e2113, (_e2113 < _e1997));
let _e2120 = global_3.member[bitcast<u32>(select(0i, _e2115, (_e2115 > 0i)))];
let _e2121 = local_8;
let _e2122 = local_10;
let _e2125 = local_9;
let _e2126 = ((_e2121 + (10i * _e2122)) + _e2125);
let _e2128 = select(_e1997, _e2126, (_e2126 < _e1997));
let _e2133 = global_3.member[bitcast<u32>(select(0i, _e2128, (_e2128 > 0i)))];
let _e2134 = local_8;
let _e2135 = local_10;
let _e2138 = local_9;
let _e2139 = ((_e2134 + (11i * _e2135)) + _e2138);
let _e2141 = select(_e1997, _e2139, (_e2139 < _e1997));
let _e2146 = global_3.member[bitcast<u32>(select(0i, _e2141, (_e2141 > 0i)))];
let _e2147 = local_8;
let _e2148 = local_10;
let _e2151 = local_9;
let _e2152 = ((_e2147 + (12i * _e2148)) + _e2151);
let _e2154 = select(_e1997, _e2152, (_e2152 < _e1997));
let _e2159 = global_3.member[bitcast<u32>(select(0i, _e2154, (_e2154 > 0i)))];
let _e2160 = local_8;
let _e2161 = local_10;
let _e2164 = local_9;
let _e2165 = ((_e2160 + (13i * _e2161)) + _e2164);
let _e2167 = select(_e1997, _e2165, (_e2165 < _e1997));
let _e2172 = global_3.member[bitcast<u32>(select(0i, _e2167, (_e2167 > 0i)))];
let _e2173 = local_8;
let _e2174 = local_10;
let _e2177 = local_9;
let _e2178 = ((_e2173 + (14i * _e2174)) + _e2177);
let _e2180 = select(_e1997, _e2178, (_e2178 < _e1997));
let _e2185 = global_3.member[bitcast<u32>(select(0i, _e2180, (_e2180 > 0i)))];
let _e2186 = local_8;
let _e2187 = local_10;
let _e2190 = local_9;
let _e2191 = ((_e2186 + (15i * _e2187)) + _e2190);
let _e2193 = select(_e1997, _e2191, (_e2191 < _e1997));
let _e2198 = global_3.member[bitcast<u32>(select(0i, _e2193, (_e2193 > 0i)))];
let _e2199 = local_8;
let _e2200 = local_10;
let _e2203 = local_9;
let _e2204 = ((_e2199 + (16i * _e2200)) + _e2203);
let _e2206 = select(_e1997, _e2204, (_e2204 < _e1997));
let _e2211 = global_3.member[bitcast<u32>(select(0i, _e2206, (_e2206 > 0i)))];
let _e2212 = local_8;
let _e2213 = local_10;
let _e2216 = local_9;
let _e2217 = ((_e2212 + (17i * _e2213)) + _e2216);
let _e2219 = select(_e1997, _e2217, (_e2217 < _e1997));
let _e2224 = global_3.member[bitcast<u32>(select(0i, _e2219, (_e2219 > 0i)))];
let _e2225 = local_8;
let _e2226 = local_10;
let _e2229 = local_9;
let _e2230 = ((_e2225 + (18i * _e2226)) + _e2229);
let _e2232 = select(_e1997, _e2230, (_e2230 < _e1997));
let _e2237 = global_3.member[bitcast<u32>(select(0i, _e2232, (_e2232 > 0i)))];
let _e2238 = local_8;
let _e2239 = local_10;
let _e2242 = local_9;
let _e2243 = ((_e2238 + (19i * _e2239)) + _e2242);
let _e2245 = select(_e1997, _e2243, (_e2243 < _e1997));
let _e2250 = global_3.member[bitcast<u32>(select(0i, _e2245, (_e2245 > 0i)))];
let _e2251 = local_8;
let _e2252 = local_10;
let _e2255 = local_9;
let _e2256 = ((_e2251 + (20i * _e2252)) + _e2255);
let _e2258 = select(_e1997, _e2256, (_e2256 < _e1997));
let _e2263 = global_3.member[bitcast<u32>(select(0i, _e2258, (_e2258 > 0i)))];
let _e2264 = local_8;
let _e2265 = local_10;
let _e2268 = local_9;
let _e2269 = ((_e2264 + (23i * _e2265)) + _e2268);
let _e2271 = select(_e1997, _e2269, (_e2269 < _e1997));
let _e2276 = global_3.member[bitcast<u32>(select(0i, _e2271, (_e2271 > 0i)))];
let _e2277 = local_8;
let _e2278 = local_10;
let _e2281 = local_9;
let _e2282 = ((_e2277 + (24i * _e2278)) + _e2281);
let _e2284 = select(_e1997, _e2282, (_e2282 < _e1997));
let _e2289 = global_3.member[bitcast<u32>(select(0i, _e2284, (_e2284 > 0i)))];
let _e2294 = (((_e1295.member_1.x * _e2042) + (_e1295.member_1.y * _e2055)) + (_e1295.member_1.z * _e2068));
let _e2297 = bitcast<f32>((bitcast<u32>(_e2294) & 2147483647u));
if (_e2297 < 1e-6f) {
phi_6451_ = vec3<f32>();
phi_6452_ = true;
} else {
let _e2299 = (1f / _e2294);
let _e2308 = ((((_e1295.member_1.x * (_e1295.member.x - _e2004)) + (_e1295.member_1.y * (_e1295.member.y - _e2016))) + (_e1295.member_1.z * (_e1295.member.z - _e2029))) * _e2299);
let _e2312 = (_e2081 + (_e2159 * _e2308));
let _e2313 = (_e2094 + (_e2172 * _e2308));
let _e2314 = (_e2107 + (_e2185 * _e2308));
let _e2320 = ((((_e1295.member_1.x * _e2312) + (_e1295.member_1.y * _e2313)) + (_e1295.member_1.z * _e2314)) * _e2299);
let _e2324 = (_e2312 - (_e2042 * _e2320));
let _e2325 = (_e2313 - (_e2055 * _e2320));
let _e2326 = (_e2314 - (_e2068 * _e2320));
let _e2330 = (_e2120 + (_e2198 * _e2308));
let _e2331 = (_e2133 + (_e2211 * _e2308));
let _e2332 = (_e2146 + (_e2224 * _e2308));
let _e2338 = ((((_e1295.member_1.x * _e2330) + (_e1295.member_1.y * _e2331)) + (_e1295.member_1.z * _e2332)) * _e2299);
let _e2342 = (_e2330 - (_e2042 * _e2338));
let _e2343 = (_e2331 - (_e2055 * _e2338));
let _e2344 = (_e2332 - (_e2068 * _e2338));
let _e2380 = (((0.5f * (bitcast<f32>((bitcast<u32>((((_e2324 * _e2042) + (_e2325 * _e2055)) + (_e2326 * _e2068))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((((_e2342 * _e2042) + (_e2343 * _e2055)) + (_e2344 * _e2068))) & 2147483647u)))) + bitcast<f32>((bitcast<u32>((((_e1368 * _e2042) + (_e1369 * _e2055)) + (_e1370 * _e2068))) & 2147483647u))) + bitcast<f32>((bitcast<u32>((((_e1380 * _e2042) + (_e1381 * _e2055)) + (_e1382 * _e2068))) & 2147483647u)));
if ((_e2308 < (-(0.05f) - _e2380)) || (bitcast<f32>((bitcast<u32>((_e2308 - _e2289)) & 2147483647u)) > (_e2380 + 0.05f))) {
phi_6446_ = vec3<f32>();
phi_6447_ = true;
} else {
let _e2397 = (_e1295.member.x - (_e2004 + (_e2042 * _e2308)));
let _e2398 = (_e1295.member.y - (_e2016 + (_e2055 * _e2308)));
let _e2399 = (_e1295.member.z - (_e2029 + (_e2068 * _e2308)));
let _e2404 = (((_e2324 * _e2324) + (_e2325 * _e2325)) + (_e2326 * _e2326));
let _e2407 = sqrt(select(0f, _e2404, (_e2404 > 0f)));
let _e2412 = (((_e2342 * _e2342) + (_e2343 * _e2343)) + (_e2344 * _e2344));
let _e2415 = sqrt(select(0f, _e2412, (_e2412 > 0f)));
let _e2430 = (1f / (((((_e1369 * _e1382) - (_e1370 * _e1381)) * _e1295.member_1.x) + (((_e1370 * _e1380) - (_e1368 * _e1382)) * _e1295.member_1.y)) + (((_e1368 * _e1381) - (_e1369 * _e1380)) * _e1295.member_1.z)));
let _e2444 = (((((_e2325 * _e1382) - (_e2326 * _e1381)) * _e1295.member_1.x) + (((_e2326 * _e1380) - (_e2324 * _e1382)) * _e1295.member_1.y)) + (((_e2324 * _e1381) - (_e2325 * _e1380)) * _e1295.member_1.z));
let _e2489 = (((((_e1369 * _e2344) - (_e1370 * _e2343)) * _e1295.member_1.x) + (((_e1370 * _e2342) - (_e1368 * _e2344)) * _e1295.member_1.y)) + (((_e1368 * _e2343) - (_e1369 * _e2342)) * _e1295.member_1.z));
let _e2493 = bitcast<f32>((bitcast<u32>((_e2444 * _e2430)) & 2147483647u));
let _e2496 = bitcast<f32>((bitcast<u32>(((((((_e2343 * _e1382) - (_e2344 * _e1381)) * _e1295.member_1.x) + (((_e2344 * _e1380) - (_e2342 * _e1382)) * _e1295.member_1.y)) + (((_e2342 * _e1381) - (_e2343 * _e1380)) * _e1295.member_1.z)) * _e2430)) & 2147483647u));
let _e2500 = bitcast<f32>((bitcast<u32>(((((((_e1369 * _e2326) - (_e1370 * _e2325)) * _e1295.member_1.x) + (((_e1370 * _e2324) - (_e1368 * _e2326)) * _e1295.member_1.y)) + (((_e1368 * _e2325) - (_e1369 * _e2324)) * _e1295.member_1.z)) * _e2430)) & 2147483647u));
let _e2503 = bitcast<f32>((bitcast<u32>((_e2489 * _e2430)) & 2147483647u));
if (((_e2493 + _e2496) < 1f) && ((_e2500 + _e2503) < 1f)) {
let _e2942 = ((((((_e2398 * _e1382) - (_e2399 * _e1381)) * _e1295.member_1.x) + (((_e2399 * _e1380) - (_e2397 * _e1382)) * _e1295.member_1.y)) + (((_e2397 * _e1381) - (_e2398 * _e1380)) * _e1295.member_1.z)) * _e2430);
let _e2957 = ((((((_e1369 * _e2399) - (_e1370 * _e2398)) * _e1295.member_1.x) + (((_e1370 * _e2397) - (_e1368 * _e2399)) * _e1295.member_1.y)) + (((_e1368 * _e2398) - (_e1369 * _e2397)) * _e1295.member_1.z)) * _e2430);
let _e2958 = (1e-4f * 1f);
let _e2960 = select(_e2496, _e2493, (_e2493 > _e2496));
let _e2962 = select(_e2958, _e2960, (_e2960 > _e2958));
let _e2964 = select(_e2496, _e2493, (_e2493 < _e2496));
let _e2966 = select(_e2958, _e2964, (_e2964 > _e2958));
let _e2968 = (0.5f * (_e2962 + _e2966));
let _e2969 = (0.5f / _e2966);
let _e2970 = (1f / _e2962);
let _e2971 = (1f / 1f);
let _e2972 = (0.5f * 1f);
let _e2973 = (_e2942 + _e2972);
let _e2974 = -(_e2973);
let _e2977 = (_e2968 - select(_e2974, _e2973, (_e2973 > _e2974)));
let _e2979 = select(0f, _e2977, (_e2977 > 0f));
let _e2981 = select(_e2966, _e2979, (_e2979 < _e2966));
let _e2984 = (_e2977 - _e2966);
let _e2988 = (((_e2981 * (_e2981 * _e2969)) + select(0f, _e2984, (_e2984 > 0f))) * _e2970);
let _e2992 = (_e2942 - _e2972);
let _e2993 = -(_e2992);
let _e2996 = (_e2968 - select(_e2993, _e2992, (_e2992 > _e2993)));
let _e2998 = select(0f, _e2996, (_e2996 > 0f));
let _e3000 = select(_e2966, _e2998, (_e2998 < _e2966));
let _e3003 = (_e2996 - _e2966);
let _e3007 = (((_e3000 * (_e3000 * _e2969)) + select(0f, _e3003, (_e3003 > 0f))) * _e2970);
let _e3014 = select(_e2503, _e2500, (_e2500 > _e2503));
let _e3016 = select(_e2958, _e3014, (_e3014 > _e2958));
let _e3018 = select(_e2503, _e2500, (_e2500 < _e2503));
let _e3020 = select(_e2958, _e3018, (_e3018 > _e2958));
let _e3022 = (0.5f * (_e3016 + _e3020));
let _e3023 = (0.5f / _e3020);
let _e3024 = (1f / _e3016);
let _e3025 = (_e2957 + _e2972);
let _e3026 = -(_e3025);
let _e3029 = (_e3022 - select(_e3026, _e3025, (_e3025 > _e3026)));
let _e3031 = select(0f, _e3029, (_e3029 > 0f));
let _e3033 = select(_e3020, _e3031, (_e3031 < _e3020));
let _e3036 = (_e3029 - _e3020);
let _e3040 = (((_e3033 * (_e3033 * _e3023)) + select(0f, _e3036, (_e3036 > 0f))) * _e3024);
let _e3044 = (_e2957 - _e2972);
let _e3045 = -(_e3044);
let _e3048 = (_e3022 - select(_e3045, _e3044, (_e3044 > _e3045)));
let _e3050 = select(0f, _e3048, (_e3048 > 0f));
let _e3052 = select(_e3020, _e3050, (_e3050 < _e3020));
let _e3055 = (_e3048 - _e3020);
let _e3059 = (((_e3052 * (_e3052 * _e3023)) + select(0f, _e3055, (_e3055 > 0f))) * _e3024);
phi_5376_ = ((((select(_e2988, (1f - _e2988), (_e2973 >= 0f)) - select(_e3007, (1f - _e3007), (_e2992 >= 0f))) * _e2971) * ((select(_e3040, (1f - _e3040), (_e3025 >= 0f)) - select(_e3059, (1f - _e3059), (_e3044 >= 0f))) * _e2971)) * bitcast<f32>((bitcast<u32>(_e2430) & 2147483647u)));
} else {
let _e2521 = (((((_e2325 * _e2344) - (_e2326 * _e2343)) * _e1295.member_1.x) + (((_e2326 * _e2342) - (_e2324 * _e2344)) * _e1295.member_1.y)) + (((_e2324 * _e2343) - (_e2325 * _e2342)) * _e1295.member_1.z));
let _e2522 = (1f / _e2521);
if (bitcast<f32>((bitcast<u32>(_e2521) & 2147483647u)) > ((0.5f * _e2407) * _e2415)) {
let _e2751 = ((((((_e2398 * _e2344) - (_e2399 * _e2343)) * _e1295.member_1.x) + (((_e2399 * _e2342) - (_e2397 * _e2344)) * _e1295.member_1.y)) + (((_e2397 * _e2343) - (_e2398 * _e2342)) * _e1295.member_1.z)) * _e2522);
let _e2766 = ((((((_e2325 * _e2399) - (_e2326 * _e2398)) * _e1295.member_1.x) + (((_e2326 * _e2397) - (_e2324 * _e2399)) * _e1295.member_1.y)) + (((_e2324 * _e2398) - (_e2325 * _e2397)) * _e1295.member_1.z)) * _e2522);
let _e2801 = bitcast<f32>((bitcast<u32>((_e2489 * _e2522)) & 2147483647u));
let _e2804 = bitcast<f32>((bitcast<u32>(((((((_e1381 * _e2344) - (_e1382 * _e2343)) * _e1295.member_1.x) + (((_e1382 * _e2342) - (_e1380 * _e2344)) * _e1295.member_1.y)) + (((_e1380 * _e2343) - (_e1381 * _e2342)) * _e1295.member_1.z)) * _e2522)) & 2147483647u));
let _e2806 = select(_e2804, _e2801, (_e2801 > _e2804));
let _e2808 = select(1e-3f, _e2806, (_e2806 > 1e-3f));
let _e2811 = bitcast<f32>((bitcast<u32>(((((((_e2325 * _e1370) - (_e2326 * _e1369)) * _e1295.member_1.x) + (((_e2326 * _e1368) - (_e2324 * _e1370)) * _e1295.member_1.y)) + (((_e2324 * _e1369) - (_e2325 * _e1368)) * _e1295.member_1.z)) * _e2522)) & 2147483647u));
let _e2814 = bitcast<f32>((bitcast<u32>((_e2444 * _e2522)) & 2147483647u));
let _e2816 = select(_e2814, _e2811, (_e2811 > _e2814));
let _e2818 = select(1e-3f, _e2816, (_e2816 > 1e-3f));
let _e2819 = (1e-4f * _e2808);
let _e2821 = select(_e2819, 1f, (1f > _e2819));
let _e2823 = select(_e2819, 0f, (0f > _e2819));
let _e2825 = (0.5f * (_e2821 + _e2823));
let _e2826 = (0.5f / _e2823);
let _e2827 = (1f / _e2821);
let _e2829 = (0.5f * _e2808);
let _e2830 = (_e2751 + _e2829);
let _e2831 = -(_e2830);
let _e2834 = (_e2825 - select(_e2831, _e2830, (_e2830 > _e2831)));
let _e2836 = select(0f, _e2834, (_e2834 > 0f));
let _e2838 = select(_e2823, _e2836, (_e2836 < _e2823));
let _e2841 = (_e2834 - _e2823);
let _e2845 = (((_e2838 * (_e2838 * _e2826)) + select(0f, _e2841, (_e2841 > 0f))) * _e2827);
let _e2849 = (_e2751 - _e2829);
let _e2850 = -(_e2849);
let _e2853 = (_e2825 - select(_e2850, _e2849, (_e2849 > _e2850)));
let _e2855 = select(0f, _e2853, (_e2853 > 0f));
let _e2857 = select(_e2823, _e2855, (_e2855 < _e2823));
let _e2860 = (_e2853 - _e2823);
let _e2864 = (((_e2857 * (_e2857 * _e2826)) + select(0f, _e2860, (_e2860 > 0f))) * _e2827);
let _e2870 = (1e-4f * _e2818);
let _e2872 = select(_e2870, 1f, (1f > _e2870));
let _e2874 = select(_e2870, 0f, (0f > _e2870));
let _e2876 = (0.5f * (_e2872 + _e2874));
let _e2877 = (0.5f / _e2874);
let _e2878 = (1f / _e2872);
let _e2880 = (0.5f * _e2818);
let _e2881 = (_e2766 + _e2880);
let _e2882 = -(_e2881);
let _e2885 = (_e2876 - select(_e2882, _e2881, (_e2881 > _e2882)));
let _e2887 = select(0f, _e2885, (_e2885 > 0f));
let _e2889 = select(_e2874, _e2887, (_e2887 < _e2874));
let _e2892 = (_e2885 - _e2874);
let _e2896 = (((_e2889 * (_e2889 * _e2877)) + select(0f, _e2892, (_e2892 > 0f))) * _e2878);
let _e2900 = (_e2766 - _e2880);
let _e2901 = -(_e2900);
let _e2904 = (_e2876 - select(_e2901, _e2900, (_e2900 > _e2901)));
let _e2906 = select(0f, _e2904, (_e2904 > 0f));
let _e2908 = select(_e2874, _e2906, (_e2906 < _e2874));
let _e2911 = (_e2904 - _e2874);
let _e2915 = (((_e2908 * (_e2908 * _e2877)) + select(0f, _e2911, (_e2911 > 0f))) * _e2878);
phi_5375_ = ((((select(_e2845, (1f - _e2845), (_e2830 >= 0f)) - select(_e2864, (1f - _e2864), (_e2849 >= 0f))) * (1f / _e2808)) * ((select(_e2896, (1f - _e2896), (_e2881 >= 0f)) - select(_e2915, (1f - _e2915), (_e2900 >= 0f))) * (1f / _e2818))) * bitcast<f32>((bitcast<u32>(_e2522) & 2147483647u)));
} else {
let _e2529 = (_e2407 >= _e2415);
let _e2530 = select(_e2342, _e2324, _e2529);
let _e2531 = select(_e2343, _e2325, _e2529);
let _e2532 = select(_e2344, _e2326, _e2529);
let _e2533 = select(_e2324, _e2342, _e2529);
let _e2534 = select(_e2325, _e2343, _e2529);
let _e2535 = select(_e2326, _e2344, _e2529);
let _e2540 = (((_e2530 * _e2530) + (_e2531 * _e2531)) + (_e2532 * _e2532));
let _e2543 = sqrt(select(0f, _e2540, (_e2540 > 0f)));
let _e2546 = (1f / select(1e-30f, _e2543, (_e2543 > 1e-30f)));
let _e2547 = (_e2530 * _e2546);
let _e2548 = (_e2531 * _e2546);
let _e2549 = (_e2532 * _e2546);
let _e2552 = ((_e1295.member_1.y * _e2549) - (_e1295.member_1.z * _e2548));
let _e2555 = ((_e1295.member_1.z * _e2547) - (_e1295.member_1.x * _e2549));
let _e2558 = ((_e1295.member_1.x * _e2548) - (_e1295.member_1.y * _e2547));
let _e2566 = bitcast<f32>((bitcast<u32>((((_e1368 * _e2547) + (_e1369 * _e2548)) + (_e1370 * _e2549))) & 2147483647u));
let _e2574 = bitcast<f32>((bitcast<u32>((((_e1380 * _e2547) + (_e1381 * _e2548)) + (_e1382 * _e2549))) & 2147483647u));
let _e2576 = select(_e2574, _e2566, (_e2566 > _e2574));
let _e2577 = (1e-3f * _e2543);
let _e2579 = select(_e2577, _e2576, (_e2576 > _e2577));
let _e2587 = bitcast<f32>((bitcast<u32>((((_e1368 * _e2552) + (_e1369 * _e2555)) + (_e1370 * _e2558))) & 2147483647u));
let _e2595 = bitcast<f32>((bitcast<u32>((((_e1380 * _e2552) + (_e1381 * _e2555)) + (_e1382 * _e2558))) & 2147483647u));
let _e2597 = select(_e2595, _e2587, (_e2587 > _e2595));
let _e2599 = select(_e2577, _e2597, (_e2597 > _e2577));
let _e2604 = (((_e2397 * _e2547) + (_e2398 * _e2548)) + (_e2399 * _e2549));
let _e2612 = bitcast<f32>((bitcast<u32>((((_e2533 * _e2547) + (_e2534 * _e2548)) + (_e2535 * _e2549))) & 2147483647u));
let _e2613 = (1e-4f * _e2579);
let _e2615 = select(_e2612, _e2543, (_e2543 > _e2612));
let _e2617 = select(_e2613, _e2615, (_e2615 > _e2613));
let _e2619 = select(_e2612, _e2543, (_e2543 < _e2612));
let _e2621 = select(_e2613, _e2619, (_e2619 > _e2613));
let _e2623 = (0.5f * (_e2617 + _e2621));
let _e2624 = (0.5f / _e2621);
let _e2625 = (1f / _e2617);
let _e2627 = (0.5f * _e2579);
let _e2628 = (_e2604 + _e2627);
let _e2629 = -(_e2628);
let _e2632 = (_e2623 - select(_e2629, _e2628, (_e2628 > _e2629)));
let _e2634 = select(0f, _e2632, (_e2632 > 0f));
let _e2636 = select(_e2621, _e2634, (_e2634 < _e2621));
let _e2639 = (_e2632 - _e2621);
let _e2643 = (((_e2636 * (_e2636 * _e2624)) + select(0f, _e2639, (_e2639 > 0f))) * _e2625);
let _e2647 = (_e2604 - _e2627);
let _e2648 = -(_e2647);
let _e2651 = (_e2623 - select(_e2648, _e2647, (_e2647 > _e2648)));
let _e2653 = select(0f, _e2651, (_e2651 > 0f));
let _e2655 = select(_e2621, _e2653, (_e2653 < _e2621));
let _e2658 = (_e2651 - _e2621);
let _e2662 = (((_e2655 * (_e2655 * _e2624)) + select(0f, _e2658, (_e2658 > 0f))) * _e2625);
let _e2672 = (((_e2397 * _e2552) + (_e2398 * _e2555)) + (_e2399 * _e2558));
let _e2680 = bitcast<f32>((bitcast<u32>((((_e2533 * _e2552) + (_e2534 * _e2555)) + (_e2535 * _e2558))) & 2147483647u));
let _e2681 = (1e-4f * _e2599);
let _e2683 = select(0f, _e2680, (_e2680 > 0f));
let _e2685 = select(_e2681, _e2683, (_e2683 > _e2681));
let _e2687 = select(0f, _e2680, (_e2680 < 0f));
let _e2689 = select(_e2681, _e2687, (_e2687 > _e2681));
let _e2691 = (0.5f * (_e2685 + _e2689));
let _e2692 = (0.5f / _e2689);
let _e2693 = (1f / _e2685);
let _e2695 = (0.5f * _e2599);
let _e2696 = (_e2672 + _e2695);
let _e2697 = -(_e2696);
let _e2700 = (_e2691 - select(_e2697, _e2696, (_e2696 > _e2697)));
let _e2702 = select(0f, _e2700, (_e2700 > 0f));
let _e2704 = select(_e2689, _e2702, (_e2702 < _e2689));
let _e2707 = (_e2700 - _e2689);
let _e2711 = (((_e2704 * (_e2704 * _e2692)) + select(0f, _e2707, (_e2707 > 0f))) * _e2693);
let _e2715 = (_e2672 - _e2695);
let _e2716 = -(_e2715);
let _e2719 = (_e2691 - select(_e2716, _e2715, (_e2715 > _e2716)));
let _e2721 = select(0f, _e2719, (_e2719 > 0f));
let _e2723 = select(_e2689, _e2721, (_e2721 < _e2689));
let _e2726 = (_e2719 - _e2689);
let _e2730 = (((_e2723 * (_e2723 * _e2692)) + select(0f, _e2726, (_e2726 > 0f))) * _e2693);
phi_5375_ = (((select(_e2643, (1f - _e2643), (_e2628 >= 0f)) - select(_e2662, (1f - _e2662), (_e2647 >= 0f))) * (1f / _e2579)) * ((select(_e2711, (1f - _e2711), (_e2696 >= 0f)) - select(_e2730, (1f - _e2730), (_e2715 >= 0f))) * (1f / _e2599)));
}
let _e2927 = phi_5375_;
phi_5376_ = _e2927;
}
let _e3071 = phi_5376_;
let _e3072 = (_e3071 <= 0f);
if _e3072 {
phi_6445_ = vec3<f32>();
} else {
let _e3075 = (select(_e2276, _e2308, (_e2308 < _e2276)) - 0f);
let _e3079 = global_1.member.member_13.member_6;
if (_e3079 == 0u) {
phi_6112_ = _e3075;
} else {
let _e3082 = (_e3075 / f32(_e3079));
phi_5399_ = 0u;
phi_5402_ = 0f;
loop {
let _e3084 = phi_5399_;
let _e3086 = phi_5402_;
local_37 = _e3086;
let _e3089 = ((_e3084 < _e3079) && (_e3075 > 0f));
if _e3089 {
let _e3092 = (0f + (_e3082 * f32(_e3084)));
let _e3093 = (_e3092 + _e3082);
let _e3095 = (0.5f * (_e3092 + _e3093));
let _e3096 = (_e3093 - _e3092);
let _e3097 = (0.28867513f * _e3096);
let _e3098 = (_e3095 - _e3097);
let _e3108 = global_1.member.member_13.member_7;
let _e3109 = bitcast<i32>(_e3108);
let _e3113 = global_1.member.member_13.member_8;
let _e3114 = bitcast<i32>(_e3113);
let _e3118 = global_1.member.member_13.member_9;
let _e3119 = bitcast<i32>(_e3118);
let _e3123 = global_1.member.member_13.member_4;
let _e3130 = global_1.member.member_13.member_5;
let _e3134 = f32(_e3109);
let _e3136 = (_e3130.member - _e3123.member);
let _e3139 = (((((_e2004 + (_e2042 * _e3098)) - _e3123.member) / _e3136) * _e3134) - 0.5f);
let _e3140 = (_e3134 - 1f);
let _e3142 = select(0f, _e3139, (_e3139 > 0f));
let _e3144 = select(_e3140, _e3142, (_e3142 < _e3140));
let _e3145 = f32(_e3114);
let _e3147 = (_e3130.member_1 - _e3123.member_1);
let _e3150 = (((((_e2016 + (_e2055 * _e3098)) - _e3123.member_1) / _e3147) * _e3145) - 0.5f);
let _e3151 = (_e3145 - 1f);
let _e3153 = select(0f, _e3150, (_e3150 > 0f));
let _e3155 = select(_e3151, _e3153, (_e3153 < _e3151));
let _e3156 = f32(_e3119);
let _e3158 = (_e3130.member_2 - _e3123.member_2);
let _e3161 = (((((_e2029 + (_e2068 * _e3098)) - _e3123.member_2) / _e3158) * _e3156) - 0.5f);
let _e3162 = (_e3156 - 1f);
let _e3164 = select(0f, _e3161, (_e3161 > 0f));
let _e3166 = select(_e3162, _e3164, (_e3164 < _e3162));
let _e3168 = select(0f, _e3144, (_e3144 > 0f));
let _e3170 = select(1e6f, _e3168, (_e3168 < 1e6f));
let _e3177 = select(0i, select(select(i32(_e3170), i32(-2147483648), (_e3170 < -2147483600f)), 2147483647i, (_e3170 > 2147483500f)), (_e3170 == _e3170));
let _e3181 = (_e3177 - select(0i, 1i, (_e3170 < f32(_e3177))));
let _e3183 = select(0f, _e3155, (_e3155 > 0f));
let _e3185 = select(1e6f, _e3183, (_e3183 < 1e6f));
let _e3192 = select(0i, select(select(i32(_e3185), i32(-2147483648), (_e3185 < -2147483600f)), 2147483647i, (_e3185 > 2147483500f)), (_e3185 == _e3185));
let _e3196 = (_e3192 - select(0i, 1i, (_e3185 < f32(_e3192))));
let _e3198 = select(0f, _e3166, (_e3166 > 0f));
let _e3200 = select(1e6f, _e3198, (_e3198 < 1e6f));
let _e3207 = select(0i, select(select(i32(_e3200), i32(-2147483648), (_e3200 < -2147483600f)), 2147483647i, (_e3200 > 2147483500f)), (_e3200 == _e3200));
let _e3211 = (_e3207 - select(0i, 1i, (_e3200 < f32(_e3207))));
let _e3215 = (_e3155 - f32(_e3196));
let _e3217 = (_e3166 - f32(_e3211));
local_6 = (_e3144 - f32(_e3181));
let _e3218 = (_e3181 + 1i);
let _e3220 = select(_e3218, 0i, (_e3218 < 0i));
if (_e3220 >= _e3109) {
phi_5537_ = (_e3109 - 1i);
} else {
phi_5537_ = _e3220;
}
let _e3224 = phi_5537_;
local_7 = (_e3224 - _e3181);
let _e3226 = (_e3196 + 1i);
let _e3228 = select(_e3226, 0i, (_e3226 < 0i));
if (_e3228 >= _e3114) {
phi_5550_ = (_e3114 - 1i);
} else {
phi_5550_ = _e3228;
}
let _e3232 = phi_5550_;
let _e3234 = ((_e3232 - _e3196) * _e3109);
let _e3235 = (_e3211 + 1i);
let _e3237 = select(_e3235, 0i, (_e3235 < 0i));
if (_e3237 >= _e3119) {
phi_5564_ = (_e3119 - 1i);
} else {
phi_5564_ = _e3237;
}
let _e3241 = phi_5564_;
let _e3248 = global_1.member.member_13.member_10;
let _e3249 = bitcast<i32>(_e3248);
let _e3254 = ((_e3249 + (((_e3211 * _e3114) + _e3196) * _e3109)) + _e3181);
let _e3256 = select(_e1318, _e3254, (_e3254 < _e1318));
let _e3261 = global_8.member[bitcast<u32>(select(0i, _e3256, (_e3256 > 0i)))];
let _e3262 = local_6;
let _e3265 = local_7;
let _e3266 = (_e3254 + _e3265);
let _e3268 = select(_e1318, _e3266, (_e3266 < _e1318));
let _e3273 = global_8.member[bitcast<u32>(select(0i, _e3268, (_e3268 > 0i)))];
let _e3274 = local_6;
let _e3277 = (1f - _e3215);
let _e3279 = (_e3254 + _e3234);
let _e3281 = select(_e1318, _e3279, (_e3279 < _e1318));
let _e3286 = global_8.member[bitcast<u32>(select(0i, _e3281, (_e3281 > 0i)))];
let _e3287 = local_6;
let _e3290 = local_7;
let _e3291 = (_e3279 + _e3290);
let _e3293 = select(_e1318, _e3291, (_e3291 < _e1318));
let _e3298 = global_8.member[bitcast<u32>(select(0i, _e3293, (_e3293 > 0i)))];
let _e3299 = local_6;
let _e3304 = (_e3254 + (((_e3241 - _e3211) * _e3109) * _e3114));
let _e3306 = select(_e1318, _e3304, (_e3304 < _e1318));
let _e3311 = global_8.member[bitcast<u32>(select(0i, _e3306, (_e3306 > 0i)))];
let _e3312 = local_6;
let _e3315 = local_7;
let _e3316 = (_e3304 + _e3315);
let _e3318 = select(_e1318, _e3316, (_e3316 < _e1318));
let _e3323 = global_8.member[bitcast<u32>(select(0i, _e3318, (_e3318 > 0i)))];
let _e3324 = local_6;
let _e3328 = (_e3304 + _e3234);
let _e3330 = select(_e1318, _e3328, (_e3328 < _e1318));
let _e3335 = global_8.member[bitcast<u32>(select(0i, _e3330, (_e3330 > 0i)))];
let _e3336 = local_6;
let _e3339 = local_7;
let _e3340 = (_e3328 + _e3339);
let _e3342 = select(_e1318, _e3340, (_e3340 < _e1318));
let _e3347 = global_8.member[bitcast<u32>(select(0i, _e3342, (_e3342 > 0i)))];
let _e3348 = local_6;
let _e3357 = (_e3095 + _e3097);
let _e3367 = (((((_e2004 + (_e2042 * _e3357)) - _e3123.member) / _e3136) * _e3134) - 0.5f);
let _e3369 = select(0f, _e3367, (_e3367 > 0f));
let _e3371 = select(_e3140, _e3369, (_e3369 < _e3140));
let _e3375 = (((((_e2016 + (_e2055 * _e3357)) - _e3123.member_1) / _e3147) * _e3145) - 0.5f);
let _e3377 = select(0f, _e3375, (_e3375 > 0f));
let _e3379 = select(_e3151, _e3377, (_e3377 < _e3151));
let _e3383 = (((((_e2029 + (_e2068 * _e3357)) - _e3123.member_2) / _e3158) * _e3156) - 0.5f);
let _e3385 = select(0f, _e3383, (_e3383 > 0f));
let _e3387 = select(_e3162, _e3385, (_e3385 < _e3162));
let _e3389 = select(0f, _e3371, (_e3371 > 0f));
let _e3391 = select(1e6f, _e3389, (_e3389 < 1e6f));
let _e3398 = select(0i, select(select(i32(_e3391), i32(-2147483648), (_e3391 < -2147483600f)), 2147483647i, (_e3391 > 2147483500f)), (_e3391 == _e3391));
let _e3402 = (_e3398 - select(0i, 1i, (_e3391 < f32(_e3398))));
let _e3404 = select(0f, _e3379, (_e3379 > 0f));
let _e3406 = select(1e6f, _e3404, (_e3404 < 1e6f));
let _e3413 = select(0i, select(select(i32(_e3406), i32(-2147483648), (_e3406 < -2147483600f)), 2147483647i, (_e3406 > 2147483500f)), (_e3406 == _e3406));
let _e3417 = (_e3413 - select(0i, 1i, (_e3406 < f32(_e3413))));
let _e3419 = select(0f, _e3387, (_e3387 > 0f));
let _e3421 = select(1e6f, _e3419, (_e3419 < 1e6f));
let _e3428 = select(0i, select(select(i32(_e3421), i32(-2147483648), (_e3421 < -2147483600f)), 2147483647i, (_e3421 > 2147483500f)), (_e3421 == _e3421));
let _e3432 = (_e3428 - select(0i, 1i, (_e3421 < f32(_e3428))));
let _e3436 = (_e3379 - f32(_e3417));
let _e3438 = (_e3387 - f32(_e3432));
local_4 = (_e3371 - f32(_e3402));
let _e3439 = (_e3402 + 1i);
let _e3441 = select(_e3439, 0i, (_e3439 < 0i));
if (_e3441 >= _e3109) {
phi_5880_ = (_e3109 - 1i);
} else {
phi_5880_ = _e3441;
}
let _e3445 = phi_5880_;
local_5 = (_e3445 - _e3402);
let _e3447 = (_e3417 + 1i);
let _e3449 = select(_e3447, 0i, (_e3447 < 0i));
if (_e3449 >= _e3114) {
phi_5893_ = (_e3114 - 1i);
} else {
phi_5893_ = _e3449;
}
let _e3453 = phi_5893_;
let _e3455 = ((_e3453 - _e3417) * _e3109);
let _e3456 = (_e3432 + 1i);
let _e3458 = select(_e3456, 0i, (_e3456 < 0i));
if (_e3458 >= _e3119) {
phi_5907_ = (_e3119 - 1i);
} else {
phi_5907_ = _e3458;
}
let _e3462 = phi_5907_;
let _e3470 = ((_e3249 + (((_e3432 * _e3114) + _e3417) * _e3109)) + _e3402);
let _e3472 = select(_e1318, _e3470, (_e3470 < _e1318));
let _e3477 = global_8.member[bitcast<u32>(select(0i, _e3472, (_e3472 > 0i)))];
let _e3478 = local_4;
let _e3481 = local_5;
let _e3482 = (_e3470 + _e3481);
let _e3484 = select(_e1318, _e3482, (_e3482 < _e1318));
let _e3489 = global_8.member[bitcast<u32>(select(0i, _e3484, (_e3484 > 0i)))];
let _e3490 = local_4;
let _e3493 = (1f - _e3436);
let _e3495 = (_e3470 + _e3455);
let _e3497 = select(_e1318, _e3495, (_e3495 < _e1318));
let _e3502 = global_8.member[bitcast<u32>(select(0i, _e3497, (_e3497 > 0i)))];
let _e3503 = local_4;
let _e3506 = local_5;
let _e3507 = (_e3495 + _e3506);
let _e3509 = select(_e1318, _e3507, (_e3507 < _e1318));
let _e3514 = global_8.member[bitcast<u32>(select(0i, _e3509, (_e3509 > 0i)))];
let _e3515 = local_4;
let _e3520 = (_e3470 + (((_e3462 - _e3432) * _e3109) * _e3114));
let _e3522 = select(_e1318, _e3520, (_e3520 < _e1318));
let _e3527 = global_8.member[bitcast<u32>(select(0i, _e3522, (_e3522 > 0i)))];
let _e3528 = local_4;
let _e3531 = local_5;
let _e3532 = (_e3520 + _e3531);
let _e3534 = select(_e1318, _e3532, (_e3532 < _e1318));
let _e3539 = global_8.member[bitcast<u32>(select(0i, _e3534, (_e3534 > 0i)))];
let _e3540 = local_4;
let _e3544 = (_e3520 + _e3455);
let _e3546 = select(_e1318, _e3544, (_e3544 < _e1318));
let _e3551 = global_8.member[bitcast<u32>(select(0i, _e3546, (_e3546 > 0i)))];
let _e3552 = local_4;
let _e3555 = local_5;
let _e3556 = (_e3544 + _e3555);
let _e3558 = select(_e1318, _e3556, (_e3556 < _e1318));
let _e3563 = global_8.member[bitcast<u32>(select(0i, _e3558, (_e3558 > 0i)))];
let _e3564 = local_4;
phi_5400_ = (_e3084 + 1u);
phi_5403_ = (_e3086 + ((0.5f * (((((((_e3261 * (1f - _e3262)) + (_e3273 * _e3274)) * _e3277) + (((_e3286 * (1f - _e3287)) + (_e3298 * _e3299)) * _e3215)) * (1f - _e3217)) + (((((_e3311 * (1f - _e3312)) + (_e3323 * _e3324)) * _e3277) + (((_e3335 * (1f - _e3336)) + (_e3347 * _e3348)) * _e3215)) * _e3217)) + ((((((_e3477 * (1f - _e3478)) + (_e3489 * _e3490)) * _e3493) + (((_e3502 * (1f - _e3503)) + (_e3514 * _e3515)) * _e3436)) * (1f - _e3438)) + (((((_e3527 * (1f - _e3528)) + (_e3539 * _e3540)) * _e3493) + (((_e3551 * (1f - _e3552)) + (_e3563 * _e3564)) * _e3436)) * _e3438)))) * _e3096));
} else {
phi_5400_ = u32();
phi_5403_ = f32();
}
let _e3579 = phi_5400_;
let _e3581 = phi_5403_;
continue;
continuing {
phi_5399_ = _e3579;
phi_5402_ = _e3581;
break if !(_e3089);
}
}
let _e4741 = local_37;
phi_6112_ = _e4741;
}
let _e3584 = phi_6112_;
let _e3597 = (0.25f * bitcast<f32>((bitcast<u32>((((_e1295.member_2.x * _e2042) + (_e1295.member_2.y * _e2055)) + (_e1295.member_2.z * _e2068))) & 2147483647u)));
let _e3604 = (((_e1295.member_1.x * _e497) + (_e1295.member_1.y * _e508)) + (_e1295.member_1.z * _e519));
let _e3606 = select(1f, -1f, (_e3604 > 0f));
let _e3614 = select(_e3606, -(_e3606), ((((_e1295.member_2.x * _e1295.member_1.x) + (_e1295.member_2.y * _e1295.member_1.y)) + (_e1295.member_2.z * _e1295.member_1.z)) < 0f));
let _e3615 = (_e1295.member_2.x * _e3614);
let _e3616 = (_e1295.member_2.y * _e3614);
let _e3617 = (_e1295.member_2.z * _e3614);
let _e3626 = ((((_e3615 * _e497) + (_e3616 * _e508)) + (_e3617 * _e519)) > 0f);
let _e3635 = -((((select(_e3615, (_e1295.member_1.x * _e3606), _e3626) * _e2042) + (select(_e3616, (_e1295.member_1.y * _e3606), _e3626) * _e2055)) + (select(_e3617, (_e1295.member_1.z * _e3606), _e3626) * _e2068)));
let _e3640 = -(_e3635);
let _e3650 = global_1.member.member_13.member;
let _e3655 = -((_e3650.member * _e3584));
let _e3657 = select(-87f, _e3655, (_e3655 > -87f));
let _e3659 = select(88f, _e3657, (_e3657 < 88f));
let _e3661 = ((_e3659 * 1.442695f) + 0.5f);
let _e3663 = select(-127f, _e3661, (_e3661 > -127f));
let _e3665 = select(128f, _e3663, (_e3663 < 128f));
let _e3672 = select(0i, select(select(i32(_e3665), i32(-2147483648), (_e3665 < -2147483600f)), 2147483647i, (_e3665 > 2147483500f)), (_e3665 == _e3665));
let _e3676 = (_e3672 - select(0i, 1i, (_e3665 < f32(_e3672))));
let _e3677 = f32(_e3676);
let _e3681 = ((_e3659 - (_e3677 * 0.6933594f)) - (_e3677 * -2.1219444e-4f));
let _e3703 = -((_e3650.member_1 * _e3584));
let _e3705 = select(-87f, _e3703, (_e3703 > -87f));
let _e3707 = select(88f, _e3705, (_e3705 < 88f));
let _e3709 = ((_e3707 * 1.442695f) + 0.5f);
let _e3711 = select(-127f, _e3709, (_e3709 > -127f));
let _e3713 = select(128f, _e3711, (_e3711 < 128f));
let _e3720 = select(0i, select(select(i32(_e3713), i32(-2147483648), (_e3713 < -2147483600f)), 2147483647i, (_e3713 > 2147483500f)), (_e3713 == _e3713));
let _e3724 = (_e3720 - select(0i, 1i, (_e3713 < f32(_e3720))));
let _e3725 = f32(_e3724);
let _e3729 = ((_e3707 - (_e3725 * 0.6933594f)) - (_e3725 * -2.1219444e-4f));
let _e3751 = -((_e3650.member_2 * _e3584));
let _e3753 = select(-87f, _e3751, (_e3751 > -87f));
let _e3755 = select(88f, _e3753, (_e3753 < 88f));
let _e3757 = ((_e3755 * 1.442695f) + 0.5f);
let _e3759 = select(-127f, _e3757, (_e3757 > -127f));
let _e3761 = select(128f, _e3759, (_e3759 < 128f));
let _e3768 = select(0i, select(select(i32(_e3761), i32(-2147483648), (_e3761 < -2147483600f)), 2147483647i, (_e3761 > 2147483500f)), (_e3761 == _e3761));
let _e3772 = (_e3768 - select(0i, 1i, (_e3761 < f32(_e3768))));
let _e3773 = f32(_e3772);
let _e3777 = ((_e3755 - (_e3773 * 0.6933594f)) - (_e3773 * -2.1219444e-4f));
let _e3803 = ((_e3071 * (select((select(0f, _e3640, (_e3640 > 0f)) * _e1295.member_4), select(0f, _e3635, (_e3635 > 0f)), ((_e2294 * _e3604) > 0f)) / select(_e3597, _e2297, (_e2297 > _e3597)))) * (1f / 3.1415927f));
phi_6445_ = vec3<f32>(((_e2237 * ((1f + (_e3681 * (1f + (_e3681 * (0.5f + (_e3681 * (0.16666667f + (_e3681 * (0.041666668f + (_e3681 * (0.008333334f + (_e3681 * (0.001388889f + (_e3681 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3676 + 127i)) << bitcast<u32>(23i))))) * _e3803), ((_e2250 * ((1f + (_e3729 * (1f + (_e3729 * (0.5f + (_e3729 * (0.16666667f + (_e3729 * (0.041666668f + (_e3729 * (0.008333334f + (_e3729 * (0.001388889f + (_e3729 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3724 + 127i)) << bitcast<u32>(23i))))) * _e3803), ((_e2263 * ((1f + (_e3777 * (1f + (_e3777 * (0.5f + (_e3777 * (0.16666667f + (_e3777 * (0.041666668f + (_e3777 * (0.008333334f + (_e3777 * (0.001388889f + (_e3777 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3772 + 127i)) << bitcast<u32>(23i))))) * _e3803));
}
let _e3809 = phi_6445_;
phi_6446_ = _e3809;
phi_6447_ = _e3072;
}
let _e3811 = phi_6446_;
let _e3813 = phi_6447_;
phi_6451_ = _e3811;
phi_6452_ = _e3813;
}
let _e3815 = phi_6451_;
let _e3817 = phi_6452_;
phi_6468_ = (_e1926 + select(_e3815, vec3<f32>(0f, 0f, 0f), vec3(_e3817)));
}
let _e3822 = phi_6468_;
phi_3419_ = _e3822;
phi_3422_ = (_e1928 + 1u);
}
let _e3825 = phi_3419_;
let _e3827 = phi_3422_;
continue;
continuing {
phi_3418_ = _e3825;
phi_3421_ = _e3827;
break if !(select(true, false, _e1932));
}
}
let _e3830 = local_17.member_1;
phi_6478_ = type_17(_e1574.member, (_e1574.member_1 + 1u));
loop {
let _e3834 = phi_6478_;
local_39 = _e3834;
let _e3840 = (((_e3834.member_1 & 3u) == 0u) && (_e3834.member < _e3830));
if _e3840 {
phi_6479_ = type_17((_e3834.member + 1u), (_e3834.member_1 >> bitcast<u32>(2i)));
} else {
phi_6479_ = type_17();
}
let _e3846 = phi_6479_;
continue;
continuing {
phi_6478_ = _e3846;
break if !(_e3840);
}
}
let _e4754 = local_38;
phi_6500_ = _e4754;
let _e4757 = local_39;
phi_6501_ = _e4757;
}
let _e3853 = phi_6500_;
let _e3855 = phi_6501_;
phi_2826_ = _e3853;
phi_2829_ = _e3855;
} else {
phi_2826_ = vec3<f32>();
phi_2829_ = type_17();
}
let _e3857 = phi_2826_;
let _e3859 = phi_2829_;
continue;
continuing {
phi_2825_ = _e3857;
phi_2828_ = _e3859;
break if !(_e1582);
}
}
let _e3868 = (1f / select(_e497, select(1e-12f, -1e-12f, (_e497 < 0f)), (bitcast<f32>((bitcast<u32>(_e497) & 2147483647u)) < 1e-12f)));
let _e3876 = (1f / select(_e508, select(1e-12f, -1e-12f, (_e508 < 0f)), (bitcast<f32>((bitcast<u32>(_e508) & 2147483647u)) < 1e-12f)));
let _e3884 = (1f / select(_e519, select(1e-12f, -1e-12f, (_e519 < 0f)), (bitcast<f32>((bitcast<u32>(_e519) & 2147483647u)) < 1e-12f)));
let _e3888 = global_1.member.member_13.member_4;
let _e3895 = global_1.member.member_13.member_5;
let _e3900 = ((_e3888.member - _e814) * _e3868);
let _e3902 = ((_e3895.member - _e814) * _e3868);
let _e3904 = ((_e3888.member_1 - _e815) * _e3876);
let _e3906 = ((_e3895.member_1 - _e815) * _e3876);
let _e3908 = ((_e3888.member_2 - _e816) * _e3884);
let _e3910 = ((_e3895.member_2 - _e816) * _e3884);
let _e3912 = select(_e3902, _e3900, (_e3900 < _e3902));
let _e3914 = select(_e3906, _e3904, (_e3904 < _e3906));
let _e3916 = select(_e3914, _e3912, (_e3912 > _e3914));
let _e3918 = select(_e3910, _e3908, (_e3908 < _e3910));
let _e3920 = select(_e3918, _e3916, (_e3916 > _e3918));
let _e3922 = select(_e3902, _e3900, (_e3900 > _e3902));
let _e3924 = select(_e3906, _e3904, (_e3904 > _e3906));
let _e3926 = select(_e3924, _e3922, (_e3922 < _e3924));
let _e3928 = select(_e3910, _e3908, (_e3908 > _e3910));
let _e3930 = select(_e3928, _e3926, (_e3926 < _e3928));
let _e3932 = select(0f, _e3920, (_e3920 > 0f));
let _e3934 = select(_e817, _e3930, (_e3930 < _e817));
let _e3935 = (_e3934 > _e3932);
let _e3936 = select(0f, _e3932, _e3935);
let _e3938 = (select(0f, _e3934, _e3935) - _e3936);
let _e3942 = global_1.member.member_13.member_6;
if (_e3942 == 0u) {
phi_7362_ = _e3938;
} else {
let _e3945 = (_e3938 / f32(_e3942));
phi_6649_ = 0u;
phi_6652_ = 0f;
loop {
let _e3947 = phi_6649_;
let _e3949 = phi_6652_;
local_40 = _e3949;
let _e3952 = ((_e3947 < _e3942) && (_e3938 > 0f));
if _e3952 {
let _e3955 = (_e3936 + (_e3945 * f32(_e3947)));
let _e3956 = (_e3955 + _e3945);
let _e3958 = (0.5f * (_e3955 + _e3956));
let _e3959 = (_e3956 - _e3955);
let _e3960 = (0.28867513f * _e3959);
let _e3961 = (_e3958 - _e3960);
let _e3971 = global_1.member.member_13.member_7;
let _e3972 = bitcast<i32>(_e3971);
let _e3976 = global_1.member.member_13.member_8;
let _e3977 = bitcast<i32>(_e3976);
let _e3981 = global_1.member.member_13.member_9;
let _e3982 = bitcast<i32>(_e3981);
let _e3983 = f32(_e3972);
let _e3985 = (_e3895.member - _e3888.member);
let _e3988 = (((((_e814 + (_e497 * _e3961)) - _e3888.member) / _e3985) * _e3983) - 0.5f);
let _e3989 = (_e3983 - 1f);
let _e3991 = select(0f, _e3988, (_e3988 > 0f));
let _e3993 = select(_e3989, _e3991, (_e3991 < _e3989));
let _e3994 = f32(_e3977);
let _e3996 = (_e3895.member_1 - _e3888.member_1);
let _e3999 = (((((_e815 + (_e508 * _e3961)) - _e3888.member_1) / _e3996) * _e3994) - 0.5f);
let _e4000 = (_e3994 - 1f);
let _e4002 = select(0f, _e3999, (_e3999 > 0f));
let _e4004 = select(_e4000, _e4002, (_e4002 < _e4000));
let _e4005 = f32(_e3982);
let _e4007 = (_e3895.member_2 - _e3888.member_2);
let _e4010 = (((((_e816 + (_e519 * _e3961)) - _e3888.member_2) / _e4007) * _e4005) - 0.5f);
let _e4011 = (_e4005 - 1f);
let _e4013 = select(0f, _e4010, (_e4010 > 0f));
let _e4015 = select(_e4011, _e4013, (_e4013 < _e4011));
let _e4017 = select(0f, _e3993, (_e3993 > 0f));
let _e4019 = select(1e6f, _e4017, (_e4017 < 1e6f));
let _e4026 = select(0i, select(select(i32(_e4019), i32(-2147483648), (_e4019 < -2147483600f)), 2147483647i, (_e4019 > 2147483500f)), (_e4019 == _e4019));
let _e4030 = (_e4026 - select(0i, 1i, (_e4019 < f32(_e4026))));
let _e4032 = select(0f, _e4004, (_e4004 > 0f));
let _e4034 = select(1e6f, _e4032, (_e4032 < 1e6f));
let _e4041 = select(0i, select(select(i32(_e4034), i32(-2147483648), (_e4034 < -2147483600f)), 2147483647i, (_e4034 > 2147483500f)), (_e4034 == _e4034));
let _e4045 = (_e4041 - select(0i, 1i, (_e4034 < f32(_e4041))));
let _e4047 = select(0f, _e4015, (_e4015 > 0f));
let _e4049 = select(1e6f, _e4047, (_e4047 < 1e6f));
let _e4056 = select(0i, select(select(i32(_e4049), i32(-2147483648), (_e4049 < -2147483600f)), 2147483647i, (_e4049 > 2147483500f)), (_e4049 == _e4049));
let _e4060 = (_e4056 - select(0i, 1i, (_e4049 < f32(_e4056))));
let _e4064 = (_e4004 - f32(_e4045));
let _e4066 = (_e4015 - f32(_e4060));
local_2 = (_e3993 - f32(_e4030));
let _e4067 = (_e4030 + 1i);
let _e4069 = select(_e4067, 0i, (_e4067 < 0i));
if (_e4069 >= _e3972) {
phi_6787_ = (_e3972 - 1i);
} else {
phi_6787_ = _e4069;
}
let _e4073 = phi_6787_;
local_3 = (_e4073 - _e4030);
let _e4075 = (_e4045 + 1i);
let _e4077 = select(_e4075, 0i, (_e4075 < 0i));
if (_e4077 >= _e3977) {
phi_6800_ = (_e3977 - 1i);
} else {
phi_6800_ = _e4077;
}
let _e4081 = phi_6800_;
let _e4083 = ((_e4081 - _e4045) * _e3972);
let _e4084 = (_e4060 + 1i);
let _e4086 = select(_e4084, 0i, (_e4084 < 0i));
if (_e4086 >= _e3982) {
phi_6814_ = (_e3982 - 1i);
} else {
phi_6814_ = _e4086;
}
let _e4090 = phi_6814_;
let _e4097 = global_1.member.member_13.member_10;
let _e4098 = bitcast<i32>(_e4097);
let _e4103 = ((_e4098 + (((_e4060 * _e3977) + _e4045) * _e3972)) + _e4030);
let _e4105 = select(_e1318, _e4103, (_e4103 < _e1318));
let _e4110 = global_8.member[bitcast<u32>(select(0i, _e4105, (_e4105 > 0i)))];
let _e4111 = local_2;
let _e4114 = local_3;
let _e4115 = (_e4103 + _e4114);
let _e4117 = select(_e1318, _e4115, (_e4115 < _e1318));
let _e4122 = global_8.member[bitcast<u32>(select(0i, _e4117, (_e4117 > 0i)))];
let _e4123 = local_2;
let _e4126 = (1f - _e4064);
let _e4128 = (_e4103 + _e4083);
let _e4130 = select(_e1318, _e4128, (_e4128 < _e1318));
let _e4135 = global_8.member[bitcast<u32>(select(0i, _e4130, (_e4130 > 0i)))];
let _e4136 = local_2;
let _e4139 = local_3;
let _e4140 = (_e4128 + _e4139);
let _e4142 = select(_e1318, _e4140, (_e4140 < _e1318));
let _e4147 = global_8.member[bitcast<u32>(select(0i, _e4142, (_e4142 > 0i)))];
let _e4148 = local_2;
let _e4153 = (_e4103 + (((_e4090 - _e4060) * _e3972) * _e3977));
let _e4155 = select(_e1318, _e4153, (_e4153 < _e1318));
let _e4160 = global_8.member[bitcast<u32>(select(0i, _e4155, (_e4155 > 0i)))];
let _e4161 = local_2;
let _e4164 = local_3;
let _e4165 = (_e4153 + _e4164);
let _e4167 = select(_e1318, _e4165, (_e4165 < _e1318));
let _e4172 = global_8.member[bitcast<u32>(select(0i, _e4167, (_e4167 > 0i)))];
let _e4173 = local_2;
let _e4177 = (_e4153 + _e4083);
let _e4179 = select(_e1318, _e4177, (_e4177 < _e1318));
let _e4184 = global_8.member[bitcast<u32>(select(0i, _e4179, (_e4179 > 0i)))];
let _e4185 = local_2;
let _e4188 = local_3;
let _e4189 = (_e4177 + _e4188);
let _e4191 = select(_e1318, _e4189, (_e4189 < _e1318));
let _e4196 = global_8.member[bitcast<u32>(select(0i, _e4191, (_e4191 > 0i)))];
let _e4197 = local_2;
let _e4206 = (_e3958 + _e3960);
let _e4216 = (((((_e814 + (_e497 * _e4206)) - _e3888.member) / _e3985) * _e3983) - 0.5f);
let _e4218 = select(0f, _e4216, (_e4216 > 0f));
let _e4220 = select(_e3989, _e4218, (_e4218 < _e3989));
let _e4224 = (((((_e815 + (_e508 * _e4206)) - _e3888.member_1) / _e3996) * _e3994) - 0.5f);
let _e4226 = select(0f, _e4224, (_e4224 > 0f));
let _e4228 = select(_e4000, _e4226, (_e4226 < _e4000));
let _e4232 = (((((_e816 + (_e519 * _e4206)) - _e3888.member_2) / _e4007) * _e4005) - 0.5f);
let _e4234 = select(0f, _e4232, (_e4232 > 0f));
let _e4236 = select(_e4011, _e4234, (_e4234 < _e4011));
let _e4238 = select(0f, _e4220, (_e4220 > 0f));
let _e4240 = select(1e6f, _e4238, (_e4238 < 1e6f));
let _e4247 = select(0i, select(select(i32(_e4240), i32(-2147483648), (_e4240 < -2147483600f)), 2147483647i, (_e4240 > 2147483500f)), (_e4240 == _e4240));
let _e4251 = (_e4247 - select(0i, 1i, (_e4240 < f32(_e4247))));
let _e4253 = select(0f, _e4228, (_e4228 > 0f));
let _e4255 = select(1e6f, _e4253, (_e4253 < 1e6f));
let _e4262 = select(0i, select(select(i32(_e4255), i32(-2147483648), (_e4255 < -2147483600f)), 2147483647i, (_e4255 > 2147483500f)), (_e4255 == _e4255));
let _e4266 = (_e4262 - select(0i, 1i, (_e4255 < f32(_e4262))));
let _e4268 = select(0f, _e4236, (_e4236 > 0f));
let _e4270 = select(1e6f, _e4268, (_e4268 < 1e6f));
let _e4277 = select(0i, select(select(i32(_e4270), i32(-2147483648), (_e4270 < -2147483600f)), 2147483647i, (_e4270 > 2147483500f)), (_e4270 == _e4270));
let _e4281 = (_e4277 - select(0i, 1i, (_e4270 < f32(_e4277))));
let _e4285 = (_e4228 - f32(_e4266));
let _e4287 = (_e4236 - f32(_e4281));
local = (_e4220 - f32(_e4251));
let _e4288 = (_e4251 + 1i);
let _e4290 = select(_e4288, 0i, (_e4288 < 0i));
if (_e4290 >= _e3972) {
phi_7130_ = (_e3972 - 1i);
} else {
phi_7130_ = _e4290;
}
let _e4294 = phi_7130_;
local_1 = (_e4294 - _e4251);
let _e4296 = (_e4266 + 1i);
let _e4298 = select(_e4296, 0i, (_e4296 < 0i));
if (_e4298 >= _e3977) {
phi_7143_ = (_e3977 - 1i);
} else {
phi_7143_ = _e4298;
}
let _e4302 = phi_7143_;
let _e4304 = ((_e4302 - _e4266) * _e3972);
let _e4305 = (_e4281 + 1i);
let _e4307 = select(_e4305, 0i, (_e4305 < 0i));
if (_e4307 >= _e3982) {
phi_7157_ = (_e3982 - 1i);
} else {
phi_7157_ = _e4307;
}
let _e4311 = phi_7157_;
let _e4319 = ((_e4098 + (((_e4281 * _e3977) + _e4266) * _e3972)) + _e4251);
let _e4321 = select(_e1318, _e4319, (_e4319 < _e1318));
let _e4326 = global_8.member[bitcast<u32>(select(0i, _e4321, (_e4321 > 0i)))];
let _e4327 = local;
let _e4330 = local_1;
let _e4331 = (_e4319 + _e4330);
let _e4333 = select(_e1318, _e4331, (_e4331 < _e1318));
let _e4338 = global_8.member[bitcast<u32>(select(0i, _e4333, (_e4333 > 0i)))];
let _e4339 = local;
let _e4342 = (1f - _e4285);
let _e4344 = (_e4319 + _e4304);
let _e4346 = select(_e1318, _e4344, (_e4344 < _e1318));
let _e4351 = global_8.member[bitcast<u32>(select(0i, _e4346, (_e4346 > 0i)))];
let _e4352 = local;
let _e4355 = local_1;
let _e4356 = (_e4344 + _e4355);
let _e4358 = select(_e1318, _e4356, (_e4356 < _e1318));
let _e4363 = global_8.member[bitcast<u32>(select(0i, _e4358, (_e4358 > 0i)))];
let _e4364 = local;
let _e4369 = (_e4319 + (((_e4311 - _e4281) * _e3972) * _e3977));
let _e4371 = select(_e1318, _e4369, (_e4369 < _e1318));
let _e4376 = global_8.member[bitcast<u32>(select(0i, _e4371, (_e4371 > 0i)))];
let _e4377 = local;
let _e4380 = local_1;
let _e4381 = (_e4369 + _e4380);
let _e4383 = select(_e1318, _e4381, (_e4381 < _e1318));
let _e4388 = global_8.member[bitcast<u32>(select(0i, _e4383, (_e4383 > 0i)))];
let _e4389 = local;
let _e4393 = (_e4369 + _e4304);
let _e4395 = select(_e1318, _e4393, (_e4393 < _e1318));
let _e4400 = global_8.member[bitcast<u32>(select(0i, _e4395, (_e4395 > 0i)))];
let _e4401 = local;
let _e4404 = local_1;
let _e4405 = (_e4393 + _e4404);
let _e4407 = select(_e1318, _e4405, (_e4405 < _e1318));
let _e4412 = global_8.member[bitcast<u32>(select(0i, _e4407, (_e4407 > 0i)))];
let _e4413 = local;
phi_6650_ = (_e3947 + 1u);
phi_6653_ = (_e3949 + ((0.5f * (((((((_e4110 * (1f - _e4111)) + (_e4122 * _e4123)) * _e4126) + (((_e4135 * (1f - _e4136)) + (_e4147 * _e4148)) * _e4064)) * (1f - _e4066)) + (((((_e4160 * (1f - _e4161)) + (_e4172 * _e4173)) * _e4126) + (((_e4184 * (1f - _e4185)) + (_e4196 * _e4197)) * _e4064)) * _e4066)) + ((((((_e4326 * (1f - _e4327)) + (_e4338 * _e4339)) * _e4342) + (((_e4351 * (1f - _e4352)) + (_e4363 * _e4364)) * _e4285)) * (1f - _e4287)) + (((((_e4376 * (1f - _e4377)) + (_e4388 * _e4389)) * _e4342) + (((_e4400 * (1f - _e4401)) + (_e4412 * _e4413)) * _e4285)) * _e4287)))) * _e3959));
} else {
phi_6650_ = u32();
phi_6653_ = f32();
}
let _e4428 = phi_6650_;
let _e4430 = phi_6653_;
continue;
continuing {
phi_6649_ = _e4428;
phi_6652_ = _e4430;
break if !(_e3952);
}
}
let _e4772 = local_40;
phi_7362_ = _e4772;
}
let _e4433 = phi_7362_;
let _e4437 = global_1.member.member_13.member;
let _e4442 = -((_e4437.member * _e4433));
let _e4444 = select(-87f, _e4442, (_e4442 > -87f));
let _e4446 = select(88f, _e4444, (_e4444 < 88f));
let _e4448 = ((_e4446 * 1.442695f) + 0.5f);
let _e4450 = select(-127f, _e4448, (_e4448 > -127f));
let _e4452 = select(128f, _e4450, (_e4450 < 128f));
let _e4459 = select(0i, select(select(i32(_e4452), i32(-2147483648), (_e4452 < -2147483600f)), 2147483647i, (_e4452 > 2147483500f)), (_e4452 == _e4452));
let _e4463 = (_e4459 - select(0i, 1i, (_e4452 < f32(_e4459))));
let _e4464 = f32(_e4463);
let _e4468 = ((_e4446 - (_e4464 * 0.6933594f)) - (_e4464 * -2.1219444e-4f));
let _e4490 = -((_e4437.member_1 * _e4433));
let _e4492 = select(-87f, _e4490, (_e4490 > -87f));
let _e4494 = select(88f, _e4492, (_e4492 < 88f));
let _e4496 = ((_e4494 * 1.442695f) + 0.5f);
let _e4498 = select(-127f, _e4496, (_e4496 > -127f));
let _e4500 = select(128f, _e4498, (_e4498 < 128f));
let _e4507 = select(0i, select(select(i32(_e4500), i32(-2147483648), (_e4500 < -2147483600f)), 2147483647i, (_e4500 > 2147483500f)), (_e4500 == _e4500));
let _e4511 = (_e4507 - select(0i, 1i, (_e4500 < f32(_e4507))));
let _e4512 = f32(_e4511);
let _e4516 = ((_e4494 - (_e4512 * 0.6933594f)) - (_e4512 * -2.1219444e-4f));
let _e4538 = -((_e4437.member_2 * _e4433));
let _e4540 = select(-87f, _e4538, (_e4538 > -87f));
let _e4542 = select(88f, _e4540, (_e4540 < 88f));
let _e4544 = ((_e4542 * 1.442695f) + 0.5f);
let _e4546 = select(-127f, _e4544, (_e4544 > -127f));
let _e4548 = select(128f, _e4546, (_e4546 < 128f));
let _e4555 = select(0i, select(select(i32(_e4548), i32(-2147483648), (_e4548 < -2147483600f)), 2147483647i, (_e4548 > 2147483500f)), (_e4548 == _e4548));
let _e4559 = (_e4555 - select(0i, 1i, (_e4548 < f32(_e4555))));
let _e4560 = f32(_e4559);
let _e4564 = ((_e4542 - (_e4560 * 0.6933594f)) - (_e4560 * -2.1219444e-4f));
let _e4587 = local_33;
let _e4592 = local_34;
let _e4597 = local_35;
phi_7601_ = array<f32, 22>(_e171, _e181, _e192, (_e203 + (((_e4587.x * _e1295.member_3.x) * ((1f + (_e4468 * (1f + (_e4468 * (0.5f + (_e4468 * (0.16666667f + (_e4468 * (0.041666668f + (_e4468 * (0.008333334f + (_e4468 * (0.001388889f + (_e4468 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4463 + 127i)) << bitcast<u32>(23i))))) * select(_e662, 1f, _e732))), (_e214 + (((_e4592.y * _e1295.member_3.y) * ((1f + (_e4516 * (1f + (_e4516 * (0.5f + (_e4516 * (0.16666667f + (_e4516 * (0.041666668f + (_e4516 * (0.008333334f + (_e4516 * (0.001388889f + (_e4516 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4511 + 127i)) << bitcast<u32>(23i))))) * select(_e673, 1f, _e732))), (_e225 + (((_e4597.z * _e1295.member_3.z) * ((1f + (_e4564 * (1f + (_e4564 * (0.5f + (_e4564 * (0.16666667f + (_e4564 * (0.041666668f + (_e4564 * (0.008333334f + (_e4564 * (0.001388889f + (_e4564 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4559 + 127i)) << bitcast<u32>(23i))))) * select(_e684, 1f, _e732))), _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357, _e368, _e379, _e390, _e401);
} else {
phi_7601_ = array<f32, 22>(_e171, _e181, _e192, _e203, _e214, _e225, _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357, _e368, _e379, _e390, _e401);
}
let _e4612 = phi_7601_;
global_5.member[_e160] = _e4612[0];
global_5.member[_e172] = _e4612[1];
global_5.member[_e183] = _e4612[2];
global_5.member[_e194] = _e4612[3];
global_5.member[_e205] = _e4612[4];
global_5.member[_e216] = _e4612[5];
global_5.member[_e227] = _e4612[6];
global_5.member[_e238] = _e4612[7];
global_5.member[_e249] = _e4612[8];
global_5.member[_e260] = _e4612[9];
global_5.member[_e271] = _e4612[10];
global_5.member[_e282] = _e4612[11];
global_5.member[_e293] = _e4612[12];
global_5.member[_e304] = _e4612[13];
global_5.member[_e315] = _e4612[14];
global_5.member[_e326] = _e4612[15];
global_5.member[_e337] = _e4612[16];
global_5.member[_e348] = _e4612[17];
global_5.member[_e359] = _e4612[18];
global_5.member[_e370] = _e4612[19];
global_5.member[_e381] = _e4612[20];
global_5.member[_e392] = _e4612[21];
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
