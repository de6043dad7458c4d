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
}
struct type_23 {
member: type_22,
}
struct type_24 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
}
struct type_26 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
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
var local_17: type_24;
var local_18: i32;
var local_19: i32;
var phi_2419_: type_26;
var phi_2483_: bool;
var phi_2515_: f32;
var phi_2556_: vec3<f32>;
var phi_2559_: u32;
var phi_2579_: u32;
var phi_2580_: u32;
var phi_2592_: u32;
var phi_2593_: u32;
var local_20: u32;
var local_21: u32;
var phi_2610_: u32;
var phi_2611_: u32;
var phi_2623_: u32;
var phi_2624_: u32;
var local_22: u32;
var local_23: u32;
var local_24: u32;
var phi_2649_: u32;
var phi_2650_: u32;
var local_25: u32;
var local_26: u32;
var phi_2667_: u32;
var phi_2668_: u32;
var local_27: u32;
var local_28: u32;
var phi_2690_: u32;
var phi_2691_: u32;
var phi_2703_: u32;
var phi_2704_: u32;
var local_29: u32;
var local_30: u32;
var local_31: u32;
var phi_2740_: u32;
var local_32: u32;
var phi_2753_: vec3<f32>;
var phi_2756_: type_17;
var phi_3015_: u32;
var phi_3032_: u32;
var phi_3035_: u32;
var phi_3054_: u32;
var phi_3033_: u32;
var phi_3036_: u32;
var phi_3344_: u32;
var phi_3346_: vec3<f32>;
var phi_3349_: u32;
var phi_3378_: u32;
var phi_3424_: i32;
var phi_4581_: u32;
var phi_4584_: f32;
var phi_4719_: i32;
var phi_4732_: i32;
var phi_4746_: i32;
var phi_5062_: i32;
var phi_5075_: i32;
var phi_5089_: i32;
var phi_4582_: u32;
var phi_4585_: f32;
var phi_5294_: f32;
var phi_5627_: vec3<f32>;
var phi_5628_: vec3<f32>;
var phi_5629_: bool;
var phi_5633_: vec3<f32>;
var phi_5634_: bool;
var phi_5638_: vec3<f32>;
var phi_5639_: bool;
var phi_5655_: vec3<f32>;
var phi_3347_: vec3<f32>;
var phi_3350_: u32;
var phi_5665_: type_17;
var phi_5666_: type_17;
var phi_5687_: vec3<f32>;
var phi_5688_: type_17;
var phi_2754_: vec3<f32>;
var phi_2757_: type_17;
var phi_2557_: vec3<f32>;
var phi_2560_: u32;
var phi_5837_: u32;
var phi_5840_: f32;
var phi_5975_: i32;
var phi_5988_: i32;
var phi_6002_: i32;
var phi_6318_: i32;
var phi_6331_: i32;
var phi_6345_: i32;
var phi_5838_: u32;
var phi_5841_: f32;
var phi_6550_: f32;
var local_33: vec3<f32>;
var local_34: vec3<f32>;
var local_35: vec3<f32>;
var phi_6786_: array<f32, 19>;
var local_36: u32;
var local_37: f32;
var local_38: vec3<f32>;
var local_39: type_17;
var local_40: vec3<f32>;
var local_41: f32;
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
let _e373 = global_1.member.member.member;
let _e377 = global_1.member.member.member_1;
let _e378 = (_e373 * _e377);
local_18 = bitcast<i32>(_e378);
let _e381 = ((_e130.y * _e373) + _e130.x);
let _e382 = bitcast<i32>(_e381);
local_19 = _e382;
let _e383 = local_18;
let _e385 = local_19;
let _e386 = ((29i * _e383) + _e385);
let _e388 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e390 = select(_e388, _e386, (_e386 < _e388));
let _e395 = global_2.member[bitcast<u32>(select(0i, _e390, (_e390 > 0i)))];
let _e397 = local_18;
let _e399 = local_19;
let _e400 = ((36i * _e397) + _e399);
let _e402 = select(_e388, _e400, (_e400 < _e388));
let _e407 = global_2.member[bitcast<u32>(select(0i, _e402, (_e402 > 0i)))];
let _e418 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e395 == 2f) && (select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < -2147483600f)), 2147483647i, (_e407 > 2147483500f)), (_e407 == _e407)) == (bitcast<i32>(_e418) + 1i)))) > 1u) {
let _e426 = select(_e388, _e382, (_e382 < _e388));
let _e432 = global_2.member[bitcast<u32>(select(0i, _e426, (_e426 > 0i)))];
let _e434 = bitcast<i32>((_e378 + _e381));
let _e436 = select(_e388, _e434, (_e434 < _e388));
let _e442 = global_2.member[bitcast<u32>(select(0i, _e436, (_e436 > 0i)))];
let _e445 = bitcast<i32>(((2u * _e378) + _e381));
let _e447 = select(_e388, _e445, (_e445 < _e388));
let _e453 = global_2.member[bitcast<u32>(select(0i, _e447, (_e447 > 0i)))];
let _e456 = bitcast<i32>(((3u * _e378) + _e381));
let _e458 = select(_e388, _e456, (_e456 < _e388));
let _e464 = global_2.member[bitcast<u32>(select(0i, _e458, (_e458 > 0i)))];
let _e467 = bitcast<i32>(((4u * _e378) + _e381));
let _e469 = select(_e388, _e467, (_e467 < _e388));
let _e475 = global_2.member[bitcast<u32>(select(0i, _e469, (_e469 > 0i)))];
let _e478 = bitcast<i32>(((5u * _e378) + _e381));
let _e480 = select(_e388, _e478, (_e478 < _e388));
let _e486 = global_2.member[bitcast<u32>(select(0i, _e480, (_e480 > 0i)))];
let _e489 = bitcast<i32>(((6u * _e378) + _e381));
let _e491 = select(_e388, _e489, (_e489 < _e388));
let _e497 = global_2.member[bitcast<u32>(select(0i, _e491, (_e491 > 0i)))];
let _e500 = bitcast<i32>(((7u * _e378) + _e381));
let _e502 = select(_e388, _e500, (_e500 < _e388));
let _e508 = global_2.member[bitcast<u32>(select(0i, _e502, (_e502 > 0i)))];
let _e511 = bitcast<i32>(((8u * _e378) + _e381));
let _e513 = select(_e388, _e511, (_e511 < _e388));
let _e519 = global_2.member[bitcast<u32>(select(0i, _e513, (_e513 > 0i)))];
let _e522 = bitcast<i32>(((9u * _e378) + _e381));
let _e524 = select(_e388, _e522, (_e522 < _e388));
let _e530 = global_2.member[bitcast<u32>(select(0i, _e524, (_e524 > 0i)))];
let _e533 = bitcast<i32>(((10u * _e378) + _e381));
let _e535 = select(_e388, _e533, (_e533 < _e388));
let _e541 = global_2.member[bitcast<u32>(select(0i, _e535, (_e535 > 0i)))];
let _e544 = bitcast<i32>(((11u * _e378) + _e381));
let _e546 = select(_e388, _e544, (_e544 < _e388));
let _e552 = global_2.member[bitcast<u32>(select(0i, _e546, (_e546 > 0i)))];
let _e555 = bitcast<i32>(((12u * _e378) + _e381));
let _e557 = select(_e388, _e555, (_e555 < _e388));
let _e563 = global_2.member[bitcast<u32>(select(0i, _e557, (_e557 > 0i)))];
let _e566 = bitcast<i32>(((13u * _e378) + _e381));
let _e568 = select(_e388, _e566, (_e566 < _e388));
let _e574 = global_2.member[bitcast<u32>(select(0i, _e568, (_e568 > 0i)))];
let _e577 = bitcast<i32>(((14u * _e378) + _e381));
let _e579 = select(_e388, _e577, (_e577 < _e388));
let _e585 = global_2.member[bitcast<u32>(select(0i, _e579, (_e579 > 0i)))];
let _e588 = bitcast<i32>(((15u * _e378) + _e381));
let _e590 = select(_e388, _e588, (_e588 < _e388));
let _e596 = global_2.member[bitcast<u32>(select(0i, _e590, (_e590 > 0i)))];
let _e599 = bitcast<i32>(((16u * _e378) + _e381));
let _e601 = select(_e388, _e599, (_e599 < _e388));
let _e607 = global_2.member[bitcast<u32>(select(0i, _e601, (_e601 > 0i)))];
let _e610 = bitcast<i32>(((17u * _e378) + _e381));
let _e612 = select(_e388, _e610, (_e610 < _e388));
let _e618 = global_2.member[bitcast<u32>(select(0i, _e612, (_e612 > 0i)))];
let _e621 = bitcast<i32>(((18u * _e378) + _e381));
let _e623 = select(_e388, _e621, (_e621 < _e388));
let _e629 = global_2.member[bitcast<u32>(select(0i, _e623, (_e623 > 0i)))];
let _e632 = bitcast<i32>(((19u * _e378) + _e381));
let _e634 = select(_e388, _e632, (_e632 < _e388));
let _e640 = global_2.member[bitcast<u32>(select(0i, _e634, (_e634 > 0i)))];
let _e643 = bitcast<i32>(((20u * _e378) + _e381));
let _e645 = select(_e388, _e643, (_e643 < _e388));
let _e651 = global_2.member[bitcast<u32>(select(0i, _e645, (_e645 > 0i)))];
let _e654 = bitcast<i32>(((23u * _e378) + _e381));
let _e656 = select(_e388, _e654, (_e654 < _e388));
let _e662 = global_2.member[bitcast<u32>(select(0i, _e656, (_e656 > 0i)))];
let _e665 = bitcast<i32>(((24u * _e378) + _e381));
let _e667 = select(_e388, _e665, (_e665 < _e388));
let _e673 = global_2.member[bitcast<u32>(select(0i, _e667, (_e667 > 0i)))];
let _e676 = bitcast<i32>(((30u * _e378) + _e381));
let _e678 = select(_e388, _e676, (_e676 < _e388));
let _e684 = global_2.member[bitcast<u32>(select(0i, _e678, (_e678 > 0i)))];
let _e691 = select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < -2147483600f)), 2147483647i, (_e662 > 2147483500f)), (_e662 == _e662));
let _e699 = (select(0i, select(select(i32(_e684), i32(-2147483648), (_e684 < -2147483600f)), 2147483647i, (_e684 > 2147483500f)), (_e684 == _e684)) == 0i);
let _e707 = global_1.member.member_1.member;
let _e713 = global_1.member.member_1.member_1;
let _e723 = global_1.member.member_2.member;
let _e724 = (((((f32(bitcast<i32>(_e130.x)) + 0.5f) / f32(bitcast<i32>(_e707))) * 2f) - 1f) * _e723);
let _e732 = global_1.member.member_2.member_1;
let _e733 = ((1f - (((f32(bitcast<i32>(_e130.y)) + 0.5f) / f32(bitcast<i32>(_e713))) * 2f)) * _e732);
let _e736 = global_1.member.member_3;
let _e745 = global_1.member.member_4;
let _e758 = global_1.member.member_2.member_3;
let _e759 = (_e758 != 0u);
let _e762 = global_1.member.member_6;
let _e769 = select(_e762.member, (_e762.member + ((_e736.member * _e724) + (_e745.member * _e733))), _e759);
let _e770 = select(_e762.member_1, (_e762.member_1 + ((_e736.member_1 * _e724) + (_e745.member_1 * _e733))), _e759);
let _e771 = select(_e762.member_2, (_e762.member_2 + ((_e736.member_2 * _e724) + (_e745.member_2 * _e733))), _e759);
let _e781 = select(_e432, _e769, _e699);
let _e782 = select(_e442, _e770, _e699);
let _e783 = select(_e453, _e771, _e699);
let _e784 = (select(0f, ((((_e432 - _e769) * _e464) + ((_e442 - _e770) * _e475)) + ((_e453 - _e771) * _e486)), _e699) + _e673);
let _e789 = select(_e784, 0f, (_e691 == -1i));
let _e793 = (_e781 + (_e464 * _e789));
let _e794 = (_e782 + (_e475 * _e789));
let _e795 = (_e783 + (_e486 * _e789));
let _e796 = vec3<f32>(_e793, _e794, _e795);
let _e799 = global_1.member.member_17;
let _e802 = (_e691 >= 0i);
if _e802 {
let _e847 = (_e691 * 19i);
let _e849 = (bitcast<i32>(_e141) - 1i);
let _e851 = select(_e849, _e847, (_e847 < _e849));
let _e857 = global_6.member[bitcast<u32>(select(0i, _e851, (_e851 > 0i)))];
let _e858 = (_e847 + 1i);
let _e860 = select(_e849, _e858, (_e858 < _e849));
let _e866 = global_6.member[bitcast<u32>(select(0i, _e860, (_e860 > 0i)))];
let _e867 = (_e847 + 2i);
let _e869 = select(_e849, _e867, (_e867 < _e849));
let _e875 = global_6.member[bitcast<u32>(select(0i, _e869, (_e869 > 0i)))];
let _e876 = (_e847 + 3i);
let _e878 = select(_e849, _e876, (_e876 < _e849));
let _e884 = global_6.member[bitcast<u32>(select(0i, _e878, (_e878 > 0i)))];
let _e885 = (_e847 + 4i);
let _e887 = select(_e849, _e885, (_e885 < _e849));
let _e893 = global_6.member[bitcast<u32>(select(0i, _e887, (_e887 > 0i)))];
let _e894 = (_e847 + 5i);
let _e896 = select(_e849, _e894, (_e894 < _e849));
let _e902 = global_6.member[bitcast<u32>(select(0i, _e896, (_e896 > 0i)))];
let _e903 = (_e847 + 6i);
let _e905 = select(_e849, _e903, (_e903 < _e849));
let _e911 = global_6.member[bitcast<u32>(select(0i, _e905, (_e905 > 0i)))];
let _e912 = (_e847 + 7i);
let _e914 = select(_e849, _e912, (_e912 < _e849));
let _e920 = global_6.member[bitcast<u32>(select(0i, _e914, (_e914 > 0i)))];
let _e921 = (_e847 + 8i);
let _e923 = select(_e849, _e921, (_e921 < _e849));
let _e929 = global_6.member[bitcast<u32>(select(0i, _e923, (_e923 > 0i)))];
let _e930 = (_e884 - _e857);
let _e931 = (_e893 - _e866);
let _e932 = (_e902 - _e875);
let _e933 = (_e911 - _e857);
let _e934 = (_e920 - _e866);
let _e935 = (_e929 - _e875);
let _e938 = ((_e931 * _e935) - (_e932 * _e934));
let _e941 = ((_e932 * _e933) - (_e930 * _e935));
let _e944 = ((_e930 * _e934) - (_e931 * _e933));
let _e945 = (_e884 - _e793);
let _e946 = (_e893 - _e794);
let _e947 = (_e902 - _e795);
let _e948 = (_e911 - _e793);
let _e949 = (_e920 - _e794);
let _e950 = (_e929 - _e795);
let _e964 = (((((_e946 * _e950) - (_e947 * _e949)) * _e938) + (((_e947 * _e948) - (_e945 * _e950)) * _e941)) + (((_e945 * _e949) - (_e946 * _e948)) * _e944));
let _e966 = select(0f, _e964, (_e964 > 0f));
let _e967 = (_e857 - _e793);
let _e968 = (_e866 - _e794);
let _e969 = (_e875 - _e795);
let _e983 = (((((_e949 * _e969) - (_e950 * _e968)) * _e938) + (((_e950 * _e967) - (_e948 * _e969)) * _e941)) + (((_e948 * _e968) - (_e949 * _e967)) * _e944));
let _e985 = select(0f, _e983, (_e983 > 0f));
let _e999 = (((((_e968 * _e947) - (_e969 * _e946)) * _e938) + (((_e969 * _e945) - (_e967 * _e947)) * _e941)) + (((_e967 * _e946) - (_e968 * _e945)) * _e944));
let _e1001 = select(0f, _e999, (_e999 > 0f));
let _e1003 = ((_e966 + _e985) + _e1001);
let _e1005 = select(1e-30f, _e1003, (_e1003 > 1e-30f));
let _e1006 = (_e966 / _e1005);
let _e1007 = (_e985 / _e1005);
let _e1008 = (_e1001 / _e1005);
let _e1013 = (((_e938 * _e938) + (_e941 * _e941)) + (_e944 * _e944));
let _e1016 = sqrt(select(0f, _e1013, (_e1013 > 0f)));
let _e1019 = (1f / select(1e-20f, _e1016, (_e1016 > 1e-20f)));
let _e1024 = (_e847 + 9i);
let _e1026 = select(_e849, _e1024, (_e1024 < _e849));
let _e1032 = global_6.member[bitcast<u32>(select(0i, _e1026, (_e1026 > 0i)))];
let _e1033 = (_e847 + 10i);
let _e1035 = select(_e849, _e1033, (_e1033 < _e849));
let _e1041 = global_6.member[bitcast<u32>(select(0i, _e1035, (_e1035 > 0i)))];
let _e1042 = (_e847 + 11i);
let _e1044 = select(_e849, _e1042, (_e1042 < _e849));
let _e1050 = global_6.member[bitcast<u32>(select(0i, _e1044, (_e1044 > 0i)))];
let _e1054 = (_e847 + 12i);
let _e1056 = select(_e849, _e1054, (_e1054 < _e849));
let _e1062 = global_6.member[bitcast<u32>(select(0i, _e1056, (_e1056 > 0i)))];
let _e1063 = (_e847 + 13i);
let _e1065 = select(_e849, _e1063, (_e1063 < _e849));
let _e1071 = global_6.member[bitcast<u32>(select(0i, _e1065, (_e1065 > 0i)))];
let _e1072 = (_e847 + 14i);
let _e1074 = select(_e849, _e1072, (_e1072 < _e849));
let _e1080 = global_6.member[bitcast<u32>(select(0i, _e1074, (_e1074 > 0i)))];
let _e1087 = (_e847 + 15i);
let _e1089 = select(_e849, _e1087, (_e1087 < _e849));
let _e1095 = global_6.member[bitcast<u32>(select(0i, _e1089, (_e1089 > 0i)))];
let _e1096 = (_e847 + 16i);
let _e1098 = select(_e849, _e1096, (_e1096 < _e849));
let _e1104 = global_6.member[bitcast<u32>(select(0i, _e1098, (_e1098 > 0i)))];
let _e1105 = (_e847 + 17i);
let _e1107 = select(_e849, _e1105, (_e1105 < _e849));
let _e1113 = global_6.member[bitcast<u32>(select(0i, _e1107, (_e1107 > 0i)))];
let _e1117 = (((_e1032 * _e1006) + (_e1062 * _e1007)) + (_e1095 * _e1008));
let _e1118 = (((_e1041 * _e1006) + (_e1071 * _e1007)) + (_e1104 * _e1008));
let _e1119 = (((_e1050 * _e1006) + (_e1080 * _e1007)) + (_e1113 * _e1008));
let _e1124 = (((_e1117 * _e1117) + (_e1118 * _e1118)) + (_e1119 * _e1119));
let _e1127 = sqrt(select(0f, _e1124, (_e1124 > 0f)));
let _e1130 = (1f / select(1e-20f, _e1127, (_e1127 > 1e-20f)));
let _e1135 = (_e847 + 18i);
let _e1137 = select(_e849, _e1135, (_e1135 < _e849));
let _e1143 = global_6.member[bitcast<u32>(select(0i, _e1137, (_e1137 > 0i)))];
let _e1152 = (select(select(0i, select(select(i32(_e1143), i32(-2147483648), (_e1143 < -2147483600f)), 2147483647i, (_e1143 > 2147483500f)), (_e1143 == _e1143)), _e691, ((_e799 & 1u) != 0u)) * 10i);
let _e1154 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1156 = select(_e1154, _e1152, (_e1152 < _e1154));
let _e1162 = global_7.member[bitcast<u32>(select(0i, _e1156, (_e1156 > 0i)))];
let _e1163 = (_e1152 + 1i);
let _e1165 = select(_e1154, _e1163, (_e1163 < _e1154));
let _e1171 = global_7.member[bitcast<u32>(select(0i, _e1165, (_e1165 > 0i)))];
let _e1172 = (_e1152 + 2i);
let _e1174 = select(_e1154, _e1172, (_e1172 < _e1154));
let _e1180 = global_7.member[bitcast<u32>(select(0i, _e1174, (_e1174 > 0i)))];
let _e1184 = (_e1152 + 3i);
let _e1186 = select(_e1154, _e1184, (_e1184 < _e1154));
let _e1192 = global_7.member[bitcast<u32>(select(0i, _e1186, (_e1186 > 0i)))];
let _e1193 = (_e1152 + 4i);
let _e1195 = select(_e1154, _e1193, (_e1193 < _e1154));
let _e1201 = global_7.member[bitcast<u32>(select(0i, _e1195, (_e1195 > 0i)))];
let _e1202 = (_e1152 + 5i);
let _e1204 = select(_e1154, _e1202, (_e1202 < _e1154));
let _e1210 = global_7.member[bitcast<u32>(select(0i, _e1204, (_e1204 > 0i)))];
let _e1217 = (_e1152 + 6i);
let _e1219 = select(_e1154, _e1217, (_e1217 < _e1154));
let _e1225 = global_7.member[bitcast<u32>(select(0i, _e1219, (_e1219 > 0i)))];
let _e1226 = (_e1152 + 7i);
let _e1228 = select(_e1154, _e1226, (_e1226 < _e1154));
let _e1234 = global_7.member[bitcast<u32>(select(0i, _e1228, (_e1228 > 0i)))];
let _e1235 = (_e1152 + 8i);
let _e1237 = select(_e1154, _e1235, (_e1235 < _e1154));
let _e1243 = global_7.member[bitcast<u32>(select(0i, _e1237, (_e1237 > 0i)))];
let _e1251 = (_e1152 + 9i);
let _e1253 = select(_e1154, _e1251, (_e1251 < _e1154));
let _e1259 = global_7.member[bitcast<u32>(select(0i, _e1253, (_e1253 > 0i)))];
phi_2419_ = type_26(_e796, vec3<f32>((_e938 * _e1019), (_e941 * _e1019), (_e944 * _e1019)), vec3<f32>((_e1117 * _e1130), (_e1118 * _e1130), (_e1119 * _e1130)), vec3<f32>((((_e1162 * _e1006) + (_e1192 * _e1007)) + (_e1225 * _e1008)), (((_e1171 * _e1006) + (_e1201 * _e1007)) + (_e1234 * _e1008)), (((_e1180 * _e1006) + (_e1210 * _e1007)) + (_e1243 * _e1008))), _e1259, true);
} else {
let _e803 = (_e691 == -3i);
let _e809 = global_1.member.member_14.member_1.member.member;
let _e814 = global_1.member.member_14.member_1.member_1;
let _e820 = global_1.member.member_14.member.member.member;
let _e825 = global_1.member.member_14.member.member_1;
let _e835 = vec3<f32>(select(_e820.member, _e809.member, _e803), select(_e820.member_1, _e809.member_1, _e803), select(_e820.member_2, _e809.member_2, _e803));
phi_2419_ = type_26(_e796, _e835, _e835, vec3<f32>(select(_e825.member, _e814.member, _e803), select(_e825.member_1, _e814.member_1, _e803), select(_e825.member_2, _e814.member_2, _e803)), 0f, false);
}
let _e1262 = phi_2419_;
let _e1265 = ((select(0i, _e691, _e802) * 19i) + 18i);
let _e1267 = (bitcast<i32>(_e141) - 1i);
let _e1269 = select(_e1267, _e1265, (_e1265 < _e1267));
let _e1275 = global_6.member[bitcast<u32>(select(0i, _e1269, (_e1269 > 0i)))];
let _e1282 = select(0i, select(select(i32(_e1275), i32(-2147483648), (_e1275 < -2147483600f)), 2147483647i, (_e1275 > 2147483500f)), (_e1275 == _e1275));
let _e1283 = (_e1282 * 4i);
let _e1285 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e1287 = select(_e1285, _e1283, (_e1283 < _e1285));
let _e1293 = global_8.member[bitcast<u32>(select(0i, _e1287, (_e1287 > 0i)))];
if _e802 {
phi_2483_ = (select(_e1293, 1f, (_e1282 == 16i)) == 0f);
} else {
phi_2483_ = (_e691 != -1i);
}
let _e1299 = phi_2483_;
if _e1299 {
let _e1303 = (_e497 + (_e563 * _e673));
let _e1304 = (_e508 + (_e574 * _e673));
let _e1305 = (_e519 + (_e585 * _e673));
let _e1309 = (_e530 + (_e596 * _e673));
let _e1310 = (_e541 + (_e607 * _e673));
let _e1311 = (_e552 + (_e618 * _e673));
let _e1320 = (((_e464 * _e1262.member_1.x) + (_e475 * _e1262.member_1.y)) + (_e486 * _e1262.member_1.z));
if ((_e1320 * _e1320) > 1e-12f) {
phi_2515_ = (1f / _e1320);
} else {
phi_2515_ = 0f;
}
let _e1325 = phi_2515_;
let _e1331 = ((((_e1303 * _e1262.member_1.x) + (_e1304 * _e1262.member_1.y)) + (_e1305 * _e1262.member_1.z)) * _e1325);
let _e1335 = (_e1303 - (_e464 * _e1331));
let _e1336 = (_e1304 - (_e475 * _e1331));
let _e1337 = (_e1305 - (_e486 * _e1331));
let _e1343 = ((((_e1309 * _e1262.member_1.x) + (_e1310 * _e1262.member_1.y)) + (_e1311 * _e1262.member_1.z)) * _e1325);
let _e1347 = (_e1309 - (_e464 * _e1343));
let _e1348 = (_e1310 - (_e475 * _e1343));
let _e1349 = (_e1311 - (_e486 * _e1343));
let _e1353 = global_1.member.member_11.member;
phi_2556_ = vec3<f32>(0f, 0f, 0f);
phi_2559_ = 1u;
loop {
let _e1357 = phi_2556_;
let _e1359 = phi_2559_;
local_33 = _e1357;
local_34 = _e1357;
local_35 = _e1357;
let _e1363 = global_1.member.member_12.member_8;
let _e1364 = (_e1359 <= _e1363);
if _e1364 {
let _e1368 = global_1.member.member_12.member_5;
phi_2579_ = 0u;
loop {
let _e1372 = phi_2579_;
local_32 = _e1372;
let _e1376 = ((1u << bitcast<u32>((_e1372 & 31u))) < _e1353);
if _e1376 {
phi_2580_ = (_e1372 + 1u);
} else {
phi_2580_ = u32();
}
let _e1379 = phi_2580_;
continue;
continuing {
phi_2579_ = _e1379;
break if !(_e1376);
}
}
phi_2592_ = 0u;
loop {
let _e1382 = phi_2592_;
local_20 = _e1382;
local_21 = _e1382;
let _e1386 = ((1u << bitcast<u32>((_e1382 & 31u))) < _e1353);
if _e1386 {
phi_2593_ = (_e1382 + 1u);
} else {
phi_2593_ = u32();
}
let _e1389 = phi_2593_;
continue;
continuing {
phi_2592_ = _e1389;
break if !(_e1386);
}
}
let _e1392 = local_20;
let _e1395 = local_21;
phi_2610_ = 0u;
loop {
let _e1398 = phi_2610_;
local_24 = _e1398;
let _e1402 = ((1u << bitcast<u32>((_e1398 & 31u))) < _e1353);
if _e1402 {
phi_2611_ = (_e1398 + 1u);
} else {
phi_2611_ = u32();
}
let _e1405 = phi_2611_;
continue;
continuing {
phi_2610_ = _e1405;
break if !(_e1402);
}
}
phi_2623_ = 0u;
loop {
let _e1408 = phi_2623_;
local_22 = _e1408;
local_23 = _e1408;
let _e1412 = ((1u << bitcast<u32>((_e1408 & 31u))) < _e1353);
if _e1412 {
phi_2624_ = (_e1408 + 1u);
} else {
phi_2624_ = u32();
}
let _e1415 = phi_2624_;
continue;
continuing {
phi_2623_ = _e1415;
break if !(_e1412);
}
}
let _e1418 = local_22;
let _e1421 = local_23;
let _e1424 = local_24;
let _e1433 = global_1.member.member_12.member_7;
phi_2649_ = 0u;
loop {
let _e1436 = phi_2649_;
local_25 = _e1436;
local_26 = _e1436;
let _e1440 = ((1u << bitcast<u32>((_e1436 & 31u))) < _e1353);
if _e1440 {
phi_2650_ = (_e1436 + 1u);
} else {
phi_2650_ = u32();
}
let _e1443 = phi_2650_;
continue;
continuing {
phi_2649_ = _e1443;
break if !(_e1440);
}
}
let _e1446 = local_25;
let _e1449 = local_26;
phi_2667_ = 0u;
loop {
let _e1452 = phi_2667_;
local_27 = _e1452;
local_28 = _e1452;
let _e1456 = ((1u << bitcast<u32>((_e1452 & 31u))) < _e1353);
if _e1456 {
phi_2668_ = (_e1452 + 1u);
} else {
phi_2668_ = u32();
}
let _e1459 = phi_2668_;
continue;
continuing {
phi_2667_ = _e1459;
break if !(_e1456);
}
}
let _e1462 = local_27;
let _e1468 = local_28;
phi_2690_ = 0u;
loop {
let _e1478 = phi_2690_;
local_31 = _e1478;
let _e1482 = ((1u << bitcast<u32>((_e1478 & 31u))) < _e1353);
if _e1482 {
phi_2691_ = (_e1478 + 1u);
} else {
phi_2691_ = u32();
}
let _e1485 = phi_2691_;
continue;
continuing {
phi_2690_ = _e1485;
break if !(_e1482);
}
}
phi_2703_ = 0u;
loop {
let _e1488 = phi_2703_;
local_29 = _e1488;
local_30 = _e1488;
let _e1492 = ((1u << bitcast<u32>((_e1488 & 31u))) < _e1353);
if _e1492 {
phi_2704_ = (_e1488 + 1u);
} else {
phi_2704_ = u32();
}
let _e1495 = phi_2704_;
continue;
continuing {
phi_2703_ = _e1495;
break if !(_e1492);
}
}
let _e1498 = local_29;
let _e1501 = local_30;
let _e1504 = local_31;
let _e1510 = (((((1u << bitcast<u32>(((2u * _e1462) & 31u))) - (1u << bitcast<u32>(((2u * (_e1468 - select(6u, _e1449, (_e1446 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1504 - select(6u, _e1501, (_e1498 < 6u)))) & 31u))));
let _e1511 = (_e1510 / 64u);
if ((_e1510 % 64u) > 0u) {
phi_2740_ = (_e1511 + 1u);
} else {
phi_2740_ = _e1511;
}
let _e1516 = phi_2740_;
let _e1519 = local_32;
local_17 = type_24(_e1519, select(6u, _e1395, (_e1392 < 6u)), (1u << bitcast<u32>(((2u * (_e1424 - select(6u, _e1421, (_e1418 < 6u)))) & 31u))), (_e1359 * _e1433), (_e1516 * 64u));
let _e1522 = local_17.member_1;
phi_2753_ = _e1357;
phi_2756_ = type_17(_e1522, 0u);
loop {
let _e1525 = phi_2753_;
let _e1527 = phi_2756_;
local_40 = _e1525;
let _e1530 = local_17.member_1;
let _e1533 = local_17.member_2;
let _e1535 = ((_e1527.member < _e1530) || (_e1527.member_1 < _e1533));
if _e1535 {
local_15.member = _e1527.member;
local_15.member_1 = _e1527.member_1;
let _e1539 = local_15.member;
let _e1540 = local_15.member_1;
let _e1542 = local_17.member;
let _e1557 = local_17.member_3;
let _e1559 = local_17.member_4;
local_16 = ((_e1557 + (18u * _e1559)) + (((((1u << bitcast<u32>(((2u * _e1542) & 31u))) - (1u << bitcast<u32>(((2u * (_e1542 - _e1539)) & 31u)))) / 3u) * 4u) + _e1540));
let _e1563 = local_16;
let _e1564 = bitcast<i32>(_e1563);
let _e1566 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1568 = select(_e1566, _e1564, (_e1564 < _e1566));
let _e1573 = global_4.member[bitcast<u32>(select(0i, _e1568, (_e1568 > 0i)))];
let _e1574 = local_16;
let _e1575 = local_17.member_4;
let _e1577 = bitcast<i32>((_e1574 + _e1575));
let _e1579 = select(_e1566, _e1577, (_e1577 < _e1566));
let _e1584 = global_4.member[bitcast<u32>(select(0i, _e1579, (_e1579 > 0i)))];
let _e1585 = local_16;
let _e1586 = local_17.member_4;
let _e1589 = bitcast<i32>((_e1585 + (2u * _e1586)));
let _e1591 = select(_e1566, _e1589, (_e1589 < _e1566));
let _e1596 = global_4.member[bitcast<u32>(select(0i, _e1591, (_e1591 > 0i)))];
let _e1597 = local_15.member;
let _e1598 = local_15.member_1;
let _e1599 = local_17.member;
let _e1613 = local_17.member_3;
let _e1614 = local_17.member_4;
local_14 = ((_e1613 + (21u * _e1614)) + (((((1u << bitcast<u32>(((2u * _e1599) & 31u))) - (1u << bitcast<u32>(((2u * (_e1599 - _e1597)) & 31u)))) / 3u) * 4u) + _e1598));
let _e1618 = local_14;
let _e1619 = bitcast<i32>(_e1618);
let _e1621 = select(_e1566, _e1619, (_e1619 < _e1566));
let _e1626 = global_4.member[bitcast<u32>(select(0i, _e1621, (_e1621 > 0i)))];
let _e1627 = local_14;
let _e1628 = local_17.member_4;
let _e1630 = bitcast<i32>((_e1627 + _e1628));
let _e1632 = select(_e1566, _e1630, (_e1630 < _e1566));
let _e1637 = global_4.member[bitcast<u32>(select(0i, _e1632, (_e1632 > 0i)))];
let _e1638 = local_14;
let _e1639 = local_17.member_4;
let _e1642 = bitcast<i32>((_e1638 + (2u * _e1639)));
let _e1644 = select(_e1566, _e1642, (_e1642 < _e1566));
let _e1649 = global_4.member[bitcast<u32>(select(0i, _e1644, (_e1644 > 0i)))];
let _e1671 = ((((_e1573 <= _e1626) && ((_e1262.member.x >= (_e1573 - 0.05f)) && (_e1262.member.x <= (_e1626 + 0.05f)))) && ((_e1262.member.y >= (_e1584 - 0.05f)) && (_e1262.member.y <= (_e1637 + 0.05f)))) && ((_e1262.member.z >= (_e1596 - 0.05f)) && (_e1262.member.z <= (_e1649 + 0.05f))));
let _e1672 = local_17.member_1;
if (_e1672 < 2u) {
let _e1674 = local_17.member_1;
phi_3015_ = _e1674;
} else {
phi_3015_ = 2u;
}
let _e1676 = phi_3015_;
if (_e1671 && (_e1527.member > _e1676)) {
phi_5687_ = _e1525;
phi_5688_ = type_17((_e1527.member - 1u), (_e1527.member_1 << bitcast<u32>(2i)));
} else {
if _e1671 {
phi_3032_ = 0u;
phi_3035_ = 0u;
loop {
let _e1680 = phi_3032_;
let _e1682 = phi_3035_;
local_36 = _e1682;
let _e1683 = (_e1680 < 16u);
if _e1683 {
let _e1684 = local_17.member_1;
if (_e1684 < 2u) {
let _e1686 = local_17.member_1;
phi_3054_ = _e1686;
} else {
phi_3054_ = 2u;
}
let _e1688 = phi_3054_;
let _e1690 = ((2u * _e1688) & 31u);
let _e1693 = ((_e1527.member_1 << bitcast<u32>(_e1690)) + _e1680);
let _e1694 = (_e1693 & 1431655765u);
let _e1698 = ((_e1694 | (_e1694 >> bitcast<u32>(1i))) & 858993459u);
let _e1702 = ((_e1698 | (_e1698 >> bitcast<u32>(2i))) & 252645135u);
let _e1706 = ((_e1702 | (_e1702 >> bitcast<u32>(4i))) & 16711935u);
let _e1713 = ((_e1693 >> bitcast<u32>(1i)) & 1431655765u);
let _e1717 = ((_e1713 | (_e1713 >> bitcast<u32>(1i))) & 858993459u);
let _e1721 = ((_e1717 | (_e1717 >> bitcast<u32>(2i))) & 252645135u);
let _e1725 = ((_e1721 | (_e1721 >> bitcast<u32>(4i))) & 16711935u);
local_12.member = 0u;
local_12.member_1 = _e1693;
let _e1739 = local_12.member;
let _e1740 = local_12.member_1;
let _e1741 = local_17.member;
let _e1755 = local_17.member_3;
let _e1756 = local_17.member_4;
local_13 = ((_e1755 + (18u * _e1756)) + (((((1u << bitcast<u32>(((2u * _e1741) & 31u))) - (1u << bitcast<u32>(((2u * (_e1741 - _e1739)) & 31u)))) / 3u) * 4u) + _e1740));
let _e1760 = local_13;
let _e1761 = bitcast<i32>(_e1760);
let _e1763 = select(_e1566, _e1761, (_e1761 < _e1566));
let _e1768 = global_4.member[bitcast<u32>(select(0i, _e1763, (_e1763 > 0i)))];
let _e1769 = local_13;
let _e1770 = local_17.member_4;
let _e1772 = bitcast<i32>((_e1769 + _e1770));
let _e1774 = select(_e1566, _e1772, (_e1772 < _e1566));
let _e1779 = global_4.member[bitcast<u32>(select(0i, _e1774, (_e1774 > 0i)))];
let _e1780 = local_13;
let _e1781 = local_17.member_4;
let _e1784 = bitcast<i32>((_e1780 + (2u * _e1781)));
let _e1786 = select(_e1566, _e1784, (_e1784 < _e1566));
let _e1791 = global_4.member[bitcast<u32>(select(0i, _e1786, (_e1786 > 0i)))];
let _e1792 = local_12.member;
let _e1793 = local_12.member_1;
let _e1794 = local_17.member;
let _e1808 = local_17.member_3;
let _e1809 = local_17.member_4;
local_11 = ((_e1808 + (21u * _e1809)) + (((((1u << bitcast<u32>(((2u * _e1794) & 31u))) - (1u << bitcast<u32>(((2u * (_e1794 - _e1792)) & 31u)))) / 3u) * 4u) + _e1793));
let _e1813 = local_11;
let _e1814 = bitcast<i32>(_e1813);
let _e1816 = select(_e1566, _e1814, (_e1814 < _e1566));
let _e1821 = global_4.member[bitcast<u32>(select(0i, _e1816, (_e1816 > 0i)))];
let _e1822 = local_11;
let _e1823 = local_17.member_4;
let _e1825 = bitcast<i32>((_e1822 + _e1823));
let _e1827 = select(_e1566, _e1825, (_e1825 < _e1566));
let _e1832 = global_4.member[bitcast<u32>(select(0i, _e1827, (_e1827 > 0i)))];
let _e1833 = local_11;
let _e1834 = local_17.member_4;
let _e1837 = bitcast<i32>((_e1833 + (2u * _e1834)));
let _e1839 = select(_e1566, _e1837, (_e1837 < _e1566));
let _e1844 = global_4.member[bitcast<u32>(select(0i, _e1839, (_e1839 > 0i)))];
phi_3033_ = (_e1680 + 1u);
phi_3036_ = (_e1682 | (select(0u, 1u, ((((_e1680 < (1u << bitcast<u32>(_e1690))) && (((_e1706 | (_e1706 >> bitcast<u32>(8i))) & 65535u) < _e1353)) && (((_e1725 | (_e1725 >> bitcast<u32>(8i))) & 65535u) < _e1353)) && ((((_e1768 <= _e1821) && ((_e1262.member.x >= (_e1768 - 0.05f)) && (_e1262.member.x <= (_e1821 + 0.05f)))) && ((_e1262.member.y >= (_e1779 - 0.05f)) && (_e1262.member.y <= (_e1832 + 0.05f)))) && ((_e1262.member.z >= (_e1791 - 0.05f)) && (_e1262.member.z <= (_e1844 + 0.05f)))))) << bitcast<u32>((_e1680 & 31u))));
} else {
phi_3033_ = u32();
phi_3036_ = u32();
}
let _e1872 = phi_3033_;
let _e1874 = phi_3036_;
continue;
continuing {
phi_3032_ = _e1872;
phi_3035_ = _e1874;
break if !(_e1683);
}
}
let _e4231 = local_36;
phi_3344_ = _e4231;
} else {
phi_3344_ = 0u;
}
let _e1877 = phi_3344_;
phi_3346_ = _e1525;
phi_3349_ = 0u;
loop {
let _e1879 = phi_3346_;
let _e1881 = phi_3349_;
local_38 = _e1879;
let _e1884 = (_e1877 >> bitcast<u32>((_e1881 & 31u)));
let _e1885 = (_e1884 == 0u);
if _e1885 {
phi_3347_ = vec3<f32>();
phi_3350_ = u32();
} else {
if ((_e1884 & 1u) == 0u) {
phi_5655_ = _e1879;
} else {
let _e1888 = local_17.member_1;
if (_e1888 < 2u) {
let _e1890 = local_17.member_1;
phi_3378_ = _e1890;
} else {
phi_3378_ = 2u;
}
let _e1892 = phi_3378_;
let _e1894 = ((2u * _e1892) & 31u);
let _e1897 = ((_e1527.member_1 << bitcast<u32>(_e1894)) + _e1881);
let _e1898 = (_e1897 & 1431655765u);
let _e1902 = ((_e1898 | (_e1898 >> bitcast<u32>(1i))) & 858993459u);
let _e1906 = ((_e1902 | (_e1902 >> bitcast<u32>(2i))) & 252645135u);
let _e1910 = ((_e1906 | (_e1906 >> bitcast<u32>(4i))) & 16711935u);
let _e1914 = ((_e1910 | (_e1910 >> bitcast<u32>(8i))) & 65535u);
let _e1917 = ((_e1897 >> bitcast<u32>(1i)) & 1431655765u);
let _e1921 = ((_e1917 | (_e1917 >> bitcast<u32>(1i))) & 858993459u);
let _e1925 = ((_e1921 | (_e1921 >> bitcast<u32>(2i))) & 252645135u);
let _e1929 = ((_e1925 | (_e1925 >> bitcast<u32>(4i))) & 16711935u);
let _e1933 = ((_e1929 | (_e1929 >> bitcast<u32>(8i))) & 65535u);
if (((_e1881 < (1u << bitcast<u32>(_e1894))) && (_e1914 < _e1353)) && (_e1933 < _e1353)) {
phi_3424_ = bitcast<i32>(((_e1933 * _e1353) + _e1914));
} else {
phi_3424_ = 0i;
}
let _e1945 = phi_3424_;
local_8 = bitcast<i32>((_e1359 * _e1368));
local_9 = _e1945;
local_10 = bitcast<i32>((_e1353 * _e1353));
let _e1946 = local_8;
let _e1947 = local_9;
let _e1948 = (_e1946 + _e1947);
let _e1950 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e1952 = select(_e1950, _e1948, (_e1948 < _e1950));
let _e1957 = global_3.member[bitcast<u32>(select(0i, _e1952, (_e1952 > 0i)))];
let _e1958 = local_8;
let _e1959 = local_10;
let _e1961 = local_9;
let _e1962 = ((_e1958 + _e1959) + _e1961);
let _e1964 = select(_e1950, _e1962, (_e1962 < _e1950));
let _e1969 = global_3.member[bitcast<u32>(select(0i, _e1964, (_e1964 > 0i)))];
let _e1970 = local_8;
let _e1971 = local_10;
let _e1974 = local_9;
let _e1975 = ((_e1970 + (2i * _e1971)) + _e1974);
let _e1977 = select(_e1950, _e1975, (_e1975 < _e1950));
let _e1982 = global_3.member[bitcast<u32>(select(0i, _e1977, (_e1977 > 0i)))];
let _e1983 = local_8;
let _e1984 = local_10;
let _e1987 = local_9;
let _e1988 = ((_e1983 + (3i * _e1984)) + _e1987);
let _e1990 = select(_e1950, _e1988, (_e1988 < _e1950));
let _e1995 = global_3.member[bitcast<u32>(select(0i, _e1990, (_e1990 > 0i)))];
let _e1996 = local_8;
let _e1997 = local_10;
let _e2000 = local_9;
let _e2001 = ((_e1996 + (4i * _e1997)) + _e2000);
let _e2003 = select(_e1950, _e2001, (_e2001 < _e1950));
let _e2008 = global_3.member[bitcast<u32>(select(0i, _e2003, (_e2003 > 0i)))];
let _e2009 = local_8;
let _e2010 = local_10;
let _e2013 = local_9;
let _e2014 = ((_e2009 + (5i * _e2010)) + _e2013);
let _e2016 = select(_e1950, _e2014, (_e2014 < _e1950));
let _e2021 = global_3.member[bitcast<u32>(select(0i, _e2016, (_e2016 > 0i)))];
let _e2022 = local_8;
let _e2023 = local_10;
let _e2026 = local_9;
let _e2027 = ((_e2022 + (6i * _e2023)) + _e2026);
let _e2029 = select(_e1950, _e2027, (_e2027 < _e1950));
let _e2034 = global_3.member[bitcast<u32>(select(0i, _e2029, (_e2029 > 0i)))];
let _e2035 = local_8;
let _e2036 = local_10;
let _e2039 = local_9;
let _e2040 = ((_e2035 + (7i * _e2036)) + _e2039);
let _e2042 = select(_e1950, _e2040, (_e2040 < _e1950));
let _e2047 = global_3.member[bitcast<u32>(select(0i, _e2042, (_e2042 > 0i)))];
let _e2048 = local_8;
let _e2049 = local_10;
let _e2052 = local_9;
let _e2053 = ((_e2048 + (8i * _e2049)) + _e2052);
let _e2055 = select(_e1950, _e2053, (_e2053 < _e1950));
let _e2060 = global_3.member[bitcast<u32>(select(0i, _e2055, (_e2055 > 0i)))];
let _e2061 = local_8;
let _e2062 = local_10;
let _e2065 = local_9;
let _e2066 = ((_e2061 + (9i * _e2062)) + _e2065);
let _e2068 = select(_e1950, _e2066, (_e2066 < _e1950));
let _e2073 = global_3.member[bitcast<u32>(select(0i, _e2068, (_e2068 > 0i)))];
let _e2074 = local_8;
let _e2075 = local_10;
let _e2078 = local_9;
let _e2079 = ((_e2074 + (10i * _e2075)) + _e2078);
let _e2081 = select(_e1950, _e2079, (_e2079 < _e1950));
let _e2086 = global_3.member[bitcast<u32>(select(0i, _e2081, (_e2081 > 0i)))];
let _e2087 = local_8;
let _e2088 = local_10;
let _e2091 = local_9;
let _e2092 = ((_e2087 + (11i * _e2088)) + _e2091);
let _e2094 = select(_e1950, _e2092, (_e2092 < _e1950));
let _e2099 = global_3.member[bitcast<u32>(select(0i, _e2094, (_e2094 > 0i)))];
let _e2100 = local_8;
let _e2101 = local_10;
let _e2104 = local_9;
let _e2105 = ((_e2100 + (12i * _e2101)) + _e2104);
let _e2107 = select(_e1950, _e2105, (_e2105 < _e1950));
let _e2112 = global_3.member[bitcast<u32>(select(0i, _e2107, (_e2107 > 0i)))];
let _e2113 = local_8;
let _e2114 = local_10;
let _e2117 = local_9;
let _e2118 = ((_e2113 + (13i * _e2114)) + _e2117);
let _e2120 = select(_e1950, _e2118, (_e2118 < _e1950));
let _e2125 = global_3.member[bitcast<u32>(select(0i, _e2120, (_e2120 > 0i)))];
let _e2126 = local_8;
let _e2127 = local_10;
let _e2130 = local_9;
let _e2131 = ((_e2126 + (14i * _e2127)) + _e2130);
let _e2133 = select(_e1950, _e2131, (_e2131 < _e1950));
let _e2138 = global_3.member[bitcast<u32>(select(0i, _e2133, (_e2133 > 0i)))];
let _e2139 = local_8;
let _e2140 = local_10;
let _e2143 = local_9;
let _e2144 = ((_e2139 + (15i * _e2140)) + _e2143);
let _e2146 = select(_e1950, _e2144, (_e2144 < _e1950));
let _e2151 = global_3.member[bitcast<u32>(select(0i, _e2146, (_e2146 > 0i)))];
let _e2152 = local_8;
let _e2153 = local_10;
let _e2156 = local_9;
let _e2157 = ((_e2152 + (16i * _e2153)) + _e2156);
let _e2159 = select(_e1950, _e2157, (_e2157 < _e1950));
let _e2164 = global_3.member[bitcast<u32>(select(0i, _e2159, (_e2159 > 0i)))];
let _e2165 = local_8;
let _e2166 = local_10;
let _e2169 = local_9;
let _e2170 = ((_e2165 + (17i * _e2166)) + _e2169);
let _e2172 = select(_e1950, _e2170, (_e2170 < _e1950));
let _e2177 = global_3.member[bitcast<u32>(select(0i, _e2172, (_e2172 > 0i)))];
let _e2178 = local_8;
let _e2179 = local_10;
let _e2182 = local_9;
let _e2183 = ((_e2178 + (18i * _e2179)) + _e2182);
let _e2185 = select(_e1950, _e2183, (_e2183 < _e1950));
let _e2190 = global_3.member[bitcast<u32>(select(0i, _e2185, (_e2185 > 0i)))];
let _e2191 = local_8;
let _e2192 = local_10;
let _e2195 = local_9;
let _e2196 = ((_e2191 + (19i * _e2192)) + _e2195);
let _e2198 = select(_e1950, _e2196, (_e2196 < _e1950));
let _e2203 = global_3.member[bitcast<u32>(select(0i, _e2198, (_e2198 > 0i)))];
let _e2204 = local_8;
let _e2205 = local_10;
let _e2208 = local_9;
let _e2209 = ((_e2204 + (20i * _e2205)) + _e2208);
let _e2211 = select(_e1950, _e2209, (_e2209 < _e1950));
let _e2216 = global_3.member[bitcast<u32>(select(0i, _e2211, (_e2211 > 0i)))];
let _e2217 = local_8;
let _e2218 = local_10;
let _e2221 = local_9;
let _e2222 = ((_e2217 + (23i * _e2218)) + _e2221);
let _e2224 = select(_e1950, _e2222, (_e2222 < _e1950));
let _e2229 = global_3.member[bitcast<u32>(select(0i, _e2224, (_e2224 > 0i)))];
let _e2230 = local_8;
let _e2231 = local_10;
let _e2234 = local_9;
let _e2235 = ((_e2230 + (24i * _e2231)) + _e2234);
let _e2237 = select(_e1950, _e2235, (_e2235 < _e1950));
let _e2242 = global_3.member[bitcast<u32>(select(0i, _e2237, (_e2237 > 0i)))];
let _e2247 = (((_e1262.member_1.x * _e1995) + (_e1262.member_1.y * _e2008)) + (_e1262.member_1.z * _e2021));
let _e2250 = bitcast<f32>((bitcast<u32>(_e2247) & 2147483647u));
if (_e2250 < 1e-6f) {
phi_5638_ = vec3<f32>();
phi_5639_ = true;
} else {
let _e2252 = (1f / _e2247);
let _e2261 = ((((_e1262.member_1.x * (_e1262.member.x - _e1957)) + (_e1262.member_1.y * (_e1262.member.y - _e1969))) + (_e1262.member_1.z * (_e1262.member.z - _e1982))) * _e2252);
let _e2265 = (_e2034 + (_e2112 * _e2261));
let _e2266 = (_e2047 + (_e2125 * _e2261));
let _e2267 = (_e2060 + (_e2138 * _e2261));
let _e2273 = ((((_e1262.member_1.x * _e2265) + (_e1262.member_1.y * _e2266)) + (_e1262.member_1.z * _e2267)) * _e2252);
let _e2277 = (_e2265 - (_e1995 * _e2273));
let _e2278 = (_e2266 - (_e2008 * _e2273));
let _e2279 = (_e2267 - (_e2021 * _e2273));
let _e2283 = (_e2073 + (_e2151 * _e2261));
let _e2284 = (_e2086 + (_e2164 * _e2261));
let _e2285 = (_e2099 + (_e2177 * _e2261));
let _e2291 = ((((_e1262.member_1.x * _e2283) + (_e1262.member_1.y * _e2284)) + (_e1262.member_1.z * _e2285)) * _e2252);
let _e2295 = (_e2283 - (_e1995 * _e2291));
let _e2296 = (_e2284 - (_e2008 * _e2291));
let _e2297 = (_e2285 - (_e2021 * _e2291));
if ((_e2261 < -(0.05f)) || (bitcast<f32>((bitcast<u32>((_e2261 - _e2242)) & 2147483647u)) > ((0.5f * (bitcast<f32>((bitcast<u32>((((_e2277 * _e1995) + (_e2278 * _e2008)) + (_e2279 * _e2021))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((((_e2295 * _e1995) + (_e2296 * _e2008)) + (_e2297 * _e2021))) & 2147483647u)))) + 0.05f))) {
phi_5633_ = vec3<f32>();
phi_5634_ = true;
} else {
let _e2338 = (((((_e2278 * _e2297) - (_e2279 * _e2296)) * _e1262.member_1.x) + (((_e2279 * _e2295) - (_e2277 * _e2297)) * _e1262.member_1.y)) + (((_e2277 * _e2296) - (_e2278 * _e2295)) * _e1262.member_1.z));
let _e2341 = bitcast<f32>((bitcast<u32>(_e2338) & 2147483647u));
if (_e2341 < 1e-12f) {
phi_5628_ = vec3<f32>();
phi_5629_ = true;
} else {
let _e2349 = (_e1262.member.x - (_e1957 + (_e1995 * _e2261)));
let _e2350 = (_e1262.member.y - (_e1969 + (_e2008 * _e2261)));
let _e2351 = (_e1262.member.z - (_e1982 + (_e2021 * _e2261)));
let _e2366 = ((((((_e2350 * _e2297) - (_e2351 * _e2296)) * _e1262.member_1.x) + (((_e2351 * _e2295) - (_e2349 * _e2297)) * _e1262.member_1.y)) + (((_e2349 * _e2296) - (_e2350 * _e2295)) * _e1262.member_1.z)) / _e2338);
let _e2381 = ((((((_e2278 * _e2351) - (_e2279 * _e2350)) * _e1262.member_1.x) + (((_e2279 * _e2349) - (_e2277 * _e2351)) * _e1262.member_1.y)) + (((_e2277 * _e2350) - (_e2278 * _e2349)) * _e1262.member_1.z)) / _e2338);
let _e2444 = bitcast<f32>((bitcast<u32>(((((((_e1336 * _e2297) - (_e1337 * _e2296)) * _e1262.member_1.x) + (((_e1337 * _e2295) - (_e1335 * _e2297)) * _e1262.member_1.y)) + (((_e1335 * _e2296) - (_e1336 * _e2295)) * _e1262.member_1.z)) / _e2338)) & 2147483647u));
let _e2447 = bitcast<f32>((bitcast<u32>(((((((_e1348 * _e2297) - (_e1349 * _e2296)) * _e1262.member_1.x) + (((_e1349 * _e2295) - (_e1347 * _e2297)) * _e1262.member_1.y)) + (((_e1347 * _e2296) - (_e1348 * _e2295)) * _e1262.member_1.z)) / _e2338)) & 2147483647u));
let _e2449 = select(_e2447, _e2444, (_e2444 > _e2447));
let _e2451 = select(1e-3f, _e2449, (_e2449 > 1e-3f));
let _e2454 = bitcast<f32>((bitcast<u32>(((((((_e2278 * _e1337) - (_e2279 * _e1336)) * _e1262.member_1.x) + (((_e2279 * _e1335) - (_e2277 * _e1337)) * _e1262.member_1.y)) + (((_e2277 * _e1336) - (_e2278 * _e1335)) * _e1262.member_1.z)) / _e2338)) & 2147483647u));
let _e2457 = bitcast<f32>((bitcast<u32>(((((((_e2278 * _e1349) - (_e2279 * _e1348)) * _e1262.member_1.x) + (((_e2279 * _e1347) - (_e2277 * _e1349)) * _e1262.member_1.y)) + (((_e2277 * _e1348) - (_e2278 * _e1347)) * _e1262.member_1.z)) / _e2338)) & 2147483647u));
let _e2459 = select(_e2457, _e2454, (_e2454 > _e2457));
let _e2461 = select(1e-3f, _e2459, (_e2459 > 1e-3f));
let _e2474 = ((bitcast<f32>((bitcast<u32>(_e2366) & 2147483647u)) > (0.5f * (1f + _e2451))) || (bitcast<f32>((bitcast<u32>(_e2381) & 2147483647u)) > (0.5f * (1f + _e2461))));
if _e2474 {
phi_5627_ = vec3<f32>();
} else {
let _e2475 = (1e-4f * _e2451);
let _e2477 = select(_e2475, 1f, (1f > _e2475));
let _e2479 = select(_e2475, 1e-4f, (1e-4f > _e2475));
let _e2481 = (0.5f * (_e2477 + _e2479));
let _e2482 = (0.5f / _e2479);
let _e2483 = (1f / _e2477);
let _e2485 = (0.5f * _e2451);
let _e2486 = (_e2366 + _e2485);
let _e2487 = -(_e2486);
let _e2490 = (_e2481 - select(_e2487, _e2486, (_e2486 > _e2487)));
let _e2492 = select(0f, _e2490, (_e2490 > 0f));
let _e2494 = select(_e2479, _e2492, (_e2492 < _e2479));
let _e2497 = (_e2490 - _e2479);
let _e2501 = (((_e2494 * (_e2494 * _e2482)) + select(0f, _e2497, (_e2497 > 0f))) * _e2483);
let _e2505 = (_e2366 - _e2485);
let _e2506 = -(_e2505);
let _e2509 = (_e2481 - select(_e2506, _e2505, (_e2505 > _e2506)));
let _e2511 = select(0f, _e2509, (_e2509 > 0f));
let _e2513 = select(_e2479, _e2511, (_e2511 < _e2479));
let _e2516 = (_e2509 - _e2479);
let _e2520 = (((_e2513 * (_e2513 * _e2482)) + select(0f, _e2516, (_e2516 > 0f))) * _e2483);
let _e2526 = (1e-4f * _e2461);
let _e2528 = select(_e2526, 1f, (1f > _e2526));
let _e2530 = select(_e2526, 1e-4f, (1e-4f > _e2526));
let _e2532 = (0.5f * (_e2528 + _e2530));
let _e2533 = (0.5f / _e2530);
let _e2534 = (1f / _e2528);
let _e2536 = (0.5f * _e2461);
let _e2537 = (_e2381 + _e2536);
let _e2538 = -(_e2537);
let _e2541 = (_e2532 - select(_e2538, _e2537, (_e2537 > _e2538)));
let _e2543 = select(0f, _e2541, (_e2541 > 0f));
let _e2545 = select(_e2530, _e2543, (_e2543 < _e2530));
let _e2548 = (_e2541 - _e2530);
let _e2552 = (((_e2545 * (_e2545 * _e2533)) + select(0f, _e2548, (_e2548 > 0f))) * _e2534);
let _e2556 = (_e2381 - _e2536);
let _e2557 = -(_e2556);
let _e2560 = (_e2532 - select(_e2557, _e2556, (_e2556 > _e2557)));
let _e2562 = select(0f, _e2560, (_e2560 > 0f));
let _e2564 = select(_e2530, _e2562, (_e2562 < _e2530));
let _e2567 = (_e2560 - _e2530);
let _e2571 = (((_e2564 * (_e2564 * _e2533)) + select(0f, _e2567, (_e2567 > 0f))) * _e2534);
let _e2581 = (select(_e2229, _e2261, (_e2261 < _e2229)) - 0f);
let _e2585 = global_1.member.member_13.member_6;
if (_e2585 == 0u) {
phi_5294_ = _e2581;
} else {
let _e2588 = (_e2581 / f32(_e2585));
phi_4581_ = 0u;
phi_4584_ = 0f;
loop {
let _e2590 = phi_4581_;
let _e2592 = phi_4584_;
local_37 = _e2592;
let _e2595 = ((_e2590 < _e2585) && (_e2581 > 0f));
if _e2595 {
let _e2598 = (0f + (_e2588 * f32(_e2590)));
let _e2599 = (_e2598 + _e2588);
let _e2601 = (0.5f * (_e2598 + _e2599));
let _e2602 = (_e2599 - _e2598);
let _e2603 = (0.28867513f * _e2602);
let _e2604 = (_e2601 - _e2603);
let _e2614 = global_1.member.member_13.member_7;
let _e2615 = bitcast<i32>(_e2614);
let _e2619 = global_1.member.member_13.member_8;
let _e2620 = bitcast<i32>(_e2619);
let _e2624 = global_1.member.member_13.member_9;
let _e2625 = bitcast<i32>(_e2624);
let _e2629 = global_1.member.member_13.member_4;
let _e2636 = global_1.member.member_13.member_5;
let _e2640 = f32(_e2615);
let _e2642 = (_e2636.member - _e2629.member);
let _e2645 = (((((_e1957 + (_e1995 * _e2604)) - _e2629.member) / _e2642) * _e2640) - 0.5f);
let _e2646 = (_e2640 - 1f);
let _e2648 = select(0f, _e2645, (_e2645 > 0f));
let _e2650 = select(_e2646, _e2648, (_e2648 < _e2646));
let _e2651 = f32(_e2620);
let _e2653 = (_e2636.member_1 - _e2629.member_1);
let _e2656 = (((((_e1969 + (_e2008 * _e2604)) - _e2629.member_1) / _e2653) * _e2651) - 0.5f);
let _e2657 = (_e2651 - 1f);
let _e2659 = select(0f, _e2656, (_e2656 > 0f));
let _e2661 = select(_e2657, _e2659, (_e2659 < _e2657));
let _e2662 = f32(_e2625);
let _e2664 = (_e2636.member_2 - _e2629.member_2);
let _e2667 = (((((_e1982 + (_e2021 * _e2604)) - _e2629.member_2) / _e2664) * _e2662) - 0.5f);
let _e2668 = (_e2662 - 1f);
let _e2670 = select(0f, _e2667, (_e2667 > 0f));
let _e2672 = select(_e2668, _e2670, (_e2670 < _e2668));
let _e2674 = select(0f, _e2650, (_e2650 > 0f));
let _e2676 = select(1e6f, _e2674, (_e2674 < 1e6f));
let _e2683 = select(0i, select(select(i32(_e2676), i32(-2147483648), (_e2676 < -2147483600f)), 2147483647i, (_e2676 > 2147483500f)), (_e2676 == _e2676));
let _e2687 = (_e2683 - select(0i, 1i, (_e2676 < f32(_e2683))));
let _e2689 = select(0f, _e2661, (_e2661 > 0f));
let _e2691 = select(1e6f, _e2689, (_e2689 < 1e6f));
let _e2698 = select(0i, select(select(i32(_e2691), i32(-2147483648), (_e2691 < -2147483600f)), 2147483647i, (_e2691 > 2147483500f)), (_e2691 == _e2691));
let _e2702 = (_e2698 - select(0i, 1i, (_e2691 < f32(_e2698))));
let _e2704 = select(0f, _e2672, (_e2672 > 0f));
let _e2706 = select(1e6f, _e2704, (_e2704 < 1e6f));
let _e2713 = select(0i, select(select(i32(_e2706), i32(-2147483648), (_e2706 < -2147483600f)), 2147483647i, (_e2706 > 2147483500f)), (_e2706 == _e2706));
let _e2717 = (_e2713 - select(0i, 1i, (_e2706 < f32(_e2713))));
let _e2721 = (_e2661 - f32(_e2702));
let _e2723 = (_e2672 - f32(_e2717));
local_6 = (_e2650 - f32(_e2687));
let _e2724 = (_e2687 + 1i);
let _e2726 = select(_e2724, 0i, (_e2724 < 0i));
if (_e2726 >= _e2615) {
phi_4719_ = (_e2615 - 1i);
} else {
phi_4719_ = _e2726;
}
let _e2730 = phi_4719_;
local_7 = (_e2730 - _e2687);
let _e2732 = (_e2702 + 1i);
let _e2734 = select(_e2732, 0i, (_e2732 < 0i));
if (_e2734 >= _e2620) {
phi_4732_ = (_e2620 - 1i);
} else {
phi_4732_ = _e2734;
}
let _e2738 = phi_4732_;
let _e2740 = ((_e2738 - _e2702) * _e2615);
let _e2741 = (_e2717 + 1i);
let _e2743 = select(_e2741, 0i, (_e2741 < 0i));
if (_e2743 >= _e2625) {
phi_4746_ = (_e2625 - 1i);
} else {
phi_4746_ = _e2743;
}
let _e2747 = phi_4746_;
let _e2754 = global_1.member.member_13.member_10;
let _e2755 = bitcast<i32>(_e2754);
let _e2760 = ((_e2755 + (((_e2717 * _e2620) + _e2702) * _e2615)) + _e2687);
let _e2762 = select(_e1285, _e2760, (_e2760 < _e1285));
let _e2767 = global_8.member[bitcast<u32>(select(0i, _e2762, (_e2762 > 0i)))];
let _e2768 = local_6;
let _e2771 = local_7;
let _e2772 = (_e2760 + _e2771);
let _e2774 = select(_e1285, _e2772, (_e2772 < _e1285));
let _e2779 = global_8.member[bitcast<u32>(select(0i, _e2774, (_e2774 > 0i)))];
let _e2780 = local_6;
let _e2783 = (1f - _e2721);
let _e2785 = (_e2760 + _e2740);
let _e2787 = select(_e1285, _e2785, (_e2785 < _e1285));
let _e2792 = global_8.member[bitcast<u32>(select(0i, _e2787, (_e2787 > 0i)))];
let _e2793 = local_6;
let _e2796 = local_7;
let _e2797 = (_e2785 + _e2796);
let _e2799 = select(_e1285, _e2797, (_e2797 < _e1285));
let _e2804 = global_8.member[bitcast<u32>(select(0i, _e2799, (_e2799 > 0i)))];
let _e2805 = local_6;
let _e2810 = (_e2760 + (((_e2747 - _e2717) * _e2615) * _e2620));
let _e2812 = select(_e1285, _e2810, (_e2810 < _e1285));
let _e2817 = global_8.member[bitcast<u32>(select(0i, _e2812, (_e2812 > 0i)))];
let _e2818 = local_6;
let _e2821 = local_7;
let _e2822 = (_e2810 + _e2821);
let _e2824 = select(_e1285, _e2822, (_e2822 < _e1285));
let _e2829 = global_8.member[bitcast<u32>(select(0i, _e2824, (_e2824 > 0i)))];
let _e2830 = local_6;
let _e2834 = (_e2810 + _e2740);
let _e2836 = select(_e1285, _e2834, (_e2834 < _e1285));
let _e2841 = global_8.member[bitcast<u32>(select(0i, _e2836, (_e2836 > 0i)))];
let _e2842 = local_6;
let _e2845 = local_7;
let _e2846 = (_e2834 + _e2845);
let _e2848 = select(_e1285, _e2846, (_e2846 < _e1285));
let _e2853 = global_8.member[bitcast<u32>(select(0i, _e2848, (_e2848 > 0i)))];
let _e2854 = local_6;
let _e2863 = (_e2601 + _e2603);
let _e2873 = (((((_e1957 + (_e1995 * _e2863)) - _e2629.member) / _e2642) * _e2640) - 0.5f);
let _e2875 = select(0f, _e2873, (_e2873 > 0f));
let _e2877 = select(_e2646, _e2875, (_e2875 < _e2646));
let _e2881 = (((((_e1969 + (_e2008 * _e2863)) - _e2629.member_1) / _e2653) * _e2651) - 0.5f);
let _e2883 = select(0f, _e2881, (_e2881 > 0f));
let _e2885 = select(_e2657, _e2883, (_e2883 < _e2657));
let _e2889 = (((((_e1982 + (_e2021 * _e2863)) - _e2629.member_2) / _e2664) * _e2662) - 0.5f);
let _e2891 = select(0f, _e2889, (_e2889 > 0f));
let _e2893 = select(_e2668, _e2891, (_e2891 < _e2668));
let _e2895 = select(0f, _e2877, (_e2877 > 0f));
let _e2897 = select(1e6f, _e2895, (_e2895 < 1e6f));
let _e2904 = select(0i, select(select(i32(_e2897), i32(-2147483648), (_e2897 < -2147483600f)), 2147483647i, (_e2897 > 2147483500f)), (_e2897 == _e2897));
let _e2908 = (_e2904 - select(0i, 1i, (_e2897 < f32(_e2904))));
let _e2910 = select(0f, _e2885, (_e2885 > 0f));
let _e2912 = select(1e6f, _e2910, (_e2910 < 1e6f));
let _e2919 = select(0i, select(select(i32(_e2912), i32(-2147483648), (_e2912 < -2147483600f)), 2147483647i, (_e2912 > 2147483500f)), (_e2912 == _e2912));
let _e2923 = (_e2919 - select(0i, 1i, (_e2912 < f32(_e2919))));
let _e2925 = select(0f, _e2893, (_e2893 > 0f));
let _e2927 = select(1e6f, _e2925, (_e2925 < 1e6f));
let _e2934 = select(0i, select(select(i32(_e2927), i32(-2147483648), (_e2927 < -2147483600f)), 2147483647i, (_e2927 > 2147483500f)), (_e2927 == _e2927));
let _e2938 = (_e2934 - select(0i, 1i, (_e2927 < f32(_e2934))));
let _e2942 = (_e2885 - f32(_e2923));
let _e2944 = (_e2893 - f32(_e2938));
local_4 = (_e2877 - f32(_e2908));
let _e2945 = (_e2908 + 1i);
let _e2947 = select(_e2945, 0i, (_e2945 < 0i));
if (_e2947 >= _e2615) {
phi_5062_ = (_e2615 - 1i);
} else {
phi_5062_ = _e2947;
}
let _e2951 = phi_5062_;
local_5 = (_e2951 - _e2908);
let _e2953 = (_e2923 + 1i);
let _e2955 = select(_e2953, 0i, (_e2953 < 0i));
if (_e2955 >= _e2620) {
phi_5075_ = (_e2620 - 1i);
} else {
phi_5075_ = _e2955;
}
let _e2959 = phi_5075_;
let _e2961 = ((_e2959 - _e2923) * _e2615);
let _e2962 = (_e2938 + 1i);
let _e2964 = select(_e2962, 0i, (_e2962 < 0i));
if (_e2964 >= _e2625) {
phi_5089_ = (_e2625 - 1i);
} else {
phi_5089_ = _e2964;
}
let _e2968 = phi_5089_;
let _e2976 = ((_e2755 + (((_e2938 * _e2620) + _e2923) * _e2615)) + _e2908);
let _e2978 = select(_e1285, _e2976, (_e2976 < _e1285));
let _e2983 = global_8.member[bitcast<u32>(select(0i, _e2978, (_e2978 > 0i)))];
let _e2984 = local_4;
let _e2987 = local_5;
let _e2988 = (_e2976 + _e2987);
let _e2990 = select(_e1285, _e2988, (_e2988 < _e1285));
let _e2995 = global_8.member[bitcast<u32>(select(0i, _e2990, (_e2990 > 0i)))];
let _e2996 = local_4;
let _e2999 = (1f - _e2942);
let _e3001 = (_e2976 + _e2961);
let _e3003 = select(_e1285, _e3001, (_e3001 < _e1285));
let _e3008 = global_8.member[bitcast<u32>(select(0i, _e3003, (_e3003 > 0i)))];
let _e3009 = local_4;
let _e3012 = local_5;
let _e3013 = (_e3001 + _e3012);
let _e3015 = select(_e1285, _e3013, (_e3013 < _e1285));
let _e3020 = global_8.member[bitcast<u32>(select(0i, _e3015, (_e3015 > 0i)))];
let _e3021 = local_4;
let _e3026 = (_e2976 + (((_e2968 - _e2938) * _e2615) * _e2620));
let _e3028 = select(_e1285, _e3026, (_e3026 < _e1285));
let _e3033 = global_8.member[bitcast<u32>(select(0i, _e3028, (_e3028 > 0i)))];
let _e3034 = local_4;
let _e3037 = local_5;
let _e3038 = (_e3026 + _e3037);
let _e3040 = select(_e1285, _e3038, (_e3038 < _e1285));
let _e3045 = global_8.member[bitcast<u32>(select(0i, _e3040, (_e3040 > 0i)))];
let _e3046 = local_4;
let _e3050 = (_e3026 + _e2961);
let _e3052 = select(_e1285, _e3050, (_e3050 < _e1285));
let _e3057 = global_8.member[bitcast<u32>(select(0i, _e3052, (_e3052 > 0i)))];
let _e3058 = local_4;
let _e3061 = local_5;
let _e3062 = (_e3050 + _e3061);
let _e3064 = select(_e1285, _e3062, (_e3062 < _e1285));
let _e3069 = global_8.member[bitcast<u32>(select(0i, _e3064, (_e3064 > 0i)))];
let _e3070 = local_4;
phi_4582_ = (_e2590 + 1u);
phi_4585_ = (_e2592 + ((0.5f * (((((((_e2767 * (1f - _e2768)) + (_e2779 * _e2780)) * _e2783) + (((_e2792 * (1f - _e2793)) + (_e2804 * _e2805)) * _e2721)) * (1f - _e2723)) + (((((_e2817 * (1f - _e2818)) + (_e2829 * _e2830)) * _e2783) + (((_e2841 * (1f - _e2842)) + (_e2853 * _e2854)) * _e2721)) * _e2723)) + ((((((_e2983 * (1f - _e2984)) + (_e2995 * _e2996)) * _e2999) + (((_e3008 * (1f - _e3009)) + (_e3020 * _e3021)) * _e2942)) * (1f - _e2944)) + (((((_e3033 * (1f - _e3034)) + (_e3045 * _e3046)) * _e2999) + (((_e3057 * (1f - _e3058)) + (_e3069 * _e3070)) * _e2942)) * _e2944)))) * _e2602));
} else {
phi_4582_ = u32();
phi_4585_ = f32();
}
let _e3085 = phi_4582_;
let _e3087 = phi_4585_;
continue;
continuing {
phi_4581_ = _e3085;
phi_4584_ = _e3087;
break if !(_e2595);
}
}
let _e4248 = local_37;
phi_5294_ = _e4248;
}
let _e3090 = phi_5294_;
let _e3103 = (0.25f * bitcast<f32>((bitcast<u32>((((_e1262.member_2.x * _e1995) + (_e1262.member_2.y * _e2008)) + (_e1262.member_2.z * _e2021))) & 2147483647u)));
let _e3110 = (((_e1262.member_1.x * _e464) + (_e1262.member_1.y * _e475)) + (_e1262.member_1.z * _e486));
let _e3112 = select(1f, -1f, (_e3110 > 0f));
let _e3120 = select(_e3112, -(_e3112), ((((_e1262.member_2.x * _e1262.member_1.x) + (_e1262.member_2.y * _e1262.member_1.y)) + (_e1262.member_2.z * _e1262.member_1.z)) < 0f));
let _e3121 = (_e1262.member_2.x * _e3120);
let _e3122 = (_e1262.member_2.y * _e3120);
let _e3123 = (_e1262.member_2.z * _e3120);
let _e3132 = ((((_e3121 * _e464) + (_e3122 * _e475)) + (_e3123 * _e486)) > 0f);
let _e3141 = -((((select(_e3121, (_e1262.member_1.x * _e3112), _e3132) * _e1995) + (select(_e3122, (_e1262.member_1.y * _e3112), _e3132) * _e2008)) + (select(_e3123, (_e1262.member_1.z * _e3112), _e3132) * _e2021)));
let _e3146 = -(_e3141);
let _e3156 = global_1.member.member_13.member;
let _e3161 = -((_e3156.member * _e3090));
let _e3163 = select(-87f, _e3161, (_e3161 > -87f));
let _e3165 = select(88f, _e3163, (_e3163 < 88f));
let _e3167 = ((_e3165 * 1.442695f) + 0.5f);
let _e3169 = select(-127f, _e3167, (_e3167 > -127f));
let _e3171 = select(128f, _e3169, (_e3169 < 128f));
let _e3178 = select(0i, select(select(i32(_e3171), i32(-2147483648), (_e3171 < -2147483600f)), 2147483647i, (_e3171 > 2147483500f)), (_e3171 == _e3171));
let _e3182 = (_e3178 - select(0i, 1i, (_e3171 < f32(_e3178))));
let _e3183 = f32(_e3182);
let _e3187 = ((_e3165 - (_e3183 * 0.6933594f)) - (_e3183 * -2.1219444e-4f));
let _e3209 = -((_e3156.member_1 * _e3090));
let _e3211 = select(-87f, _e3209, (_e3209 > -87f));
let _e3213 = select(88f, _e3211, (_e3211 < 88f));
let _e3215 = ((_e3213 * 1.442695f) + 0.5f);
let _e3217 = select(-127f, _e3215, (_e3215 > -127f));
let _e3219 = select(128f, _e3217, (_e3217 < 128f));
let _e3226 = select(0i, select(select(i32(_e3219), i32(-2147483648), (_e3219 < -2147483600f)), 2147483647i, (_e3219 > 2147483500f)), (_e3219 == _e3219));
let _e3230 = (_e3226 - select(0i, 1i, (_e3219 < f32(_e3226))));
let _e3231 = f32(_e3230);
let _e3235 = ((_e3213 - (_e3231 * 0.6933594f)) - (_e3231 * -2.1219444e-4f));
let _e3257 = -((_e3156.member_2 * _e3090));
let _e3259 = select(-87f, _e3257, (_e3257 > -87f));
let _e3261 = select(88f, _e3259, (_e3259 < 88f));
let _e3263 = ((_e3261 * 1.442695f) + 0.5f);
let _e3265 = select(-127f, _e3263, (_e3263 > -127f));
let _e3267 = select(128f, _e3265, (_e3265 < 128f));
let _e3274 = select(0i, select(select(i32(_e3267), i32(-2147483648), (_e3267 < -2147483600f)), 2147483647i, (_e3267 > 2147483500f)), (_e3267 == _e3267));
let _e3278 = (_e3274 - select(0i, 1i, (_e3267 < f32(_e3274))));
let _e3279 = f32(_e3278);
let _e3283 = ((_e3261 - (_e3279 * 0.6933594f)) - (_e3279 * -2.1219444e-4f));
let _e3309 = ((((((select(_e2501, (1f - _e2501), (_e2486 >= 0f)) - select(_e2520, (1f - _e2520), (_e2505 >= 0f))) * (1f / _e2451)) * ((select(_e2552, (1f - _e2552), (_e2537 >= 0f)) - select(_e2571, (1f - _e2571), (_e2556 >= 0f))) * (1f / _e2461))) / _e2341) * (select((select(0f, _e3146, (_e3146 > 0f)) * _e1262.member_4), select(0f, _e3141, (_e3141 > 0f)), ((_e2247 * _e3110) > 0f)) / select(_e3103, _e2250, (_e2250 > _e3103)))) * (1f / 3.1415927f));
phi_5627_ = vec3<f32>(((_e2190 * ((1f + (_e3187 * (1f + (_e3187 * (0.5f + (_e3187 * (0.16666667f + (_e3187 * (0.041666668f + (_e3187 * (0.008333334f + (_e3187 * (0.001388889f + (_e3187 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3182 + 127i)) << bitcast<u32>(23i))))) * _e3309), ((_e2203 * ((1f + (_e3235 * (1f + (_e3235 * (0.5f + (_e3235 * (0.16666667f + (_e3235 * (0.041666668f + (_e3235 * (0.008333334f + (_e3235 * (0.001388889f + (_e3235 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3230 + 127i)) << bitcast<u32>(23i))))) * _e3309), ((_e2216 * ((1f + (_e3283 * (1f + (_e3283 * (0.5f + (_e3283 * (0.16666667f + (_e3283 * (0.041666668f + (_e3283 * (0.008333334f + (_e3283 * (0.001388889f + (_e3283 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3278 + 127i)) << bitcast<u32>(23i))))) * _e3309));
}
let _e3315 = phi_5627_;
phi_5628_ = _e3315;
phi_5629_ = _e2474;
}
let _e3317 = phi_5628_;
let _e3319 = phi_5629_;
phi_5633_ = _e3317;
phi_5634_ = _e3319;
}
let _e3321 = phi_5633_;
let _e3323 = phi_5634_;
phi_5638_ = _e3321;
phi_5639_ = _e3323;
}
let _e3325 = phi_5638_;
let _e3327 = phi_5639_;
phi_5655_ = (_e1879 + select(_e3325, vec3<f32>(0f, 0f, 0f), vec3(_e3327)));
}
let _e3332 = phi_5655_;
phi_3347_ = _e3332;
phi_3350_ = (_e1881 + 1u);
}
let _e3335 = phi_3347_;
let _e3337 = phi_3350_;
continue;
continuing {
phi_3346_ = _e3335;
phi_3349_ = _e3337;
break if !(select(true, false, _e1885));
}
}
let _e3340 = local_17.member_1;
phi_5665_ = type_17(_e1527.member, (_e1527.member_1 + 1u));
loop {
let _e3344 = phi_5665_;
local_39 = _e3344;
let _e3350 = (((_e3344.member_1 & 3u) == 0u) && (_e3344.member < _e3340));
if _e3350 {
phi_5666_ = type_17((_e3344.member + 1u), (_e3344.member_1 >> bitcast<u32>(2i)));
} else {
phi_5666_ = type_17();
}
let _e3356 = phi_5666_;
continue;
continuing {
phi_5665_ = _e3356;
break if !(_e3350);
}
}
let _e4263 = local_38;
phi_5687_ = _e4263;
let _e4266 = local_39;
phi_5688_ = _e4266;
}
let _e3363 = phi_5687_;
let _e3365 = phi_5688_;
phi_2754_ = _e3363;
phi_2757_ = _e3365;
} else {
phi_2754_ = vec3<f32>();
phi_2757_ = type_17();
}
let _e3367 = phi_2754_;
let _e3369 = phi_2757_;
continue;
continuing {
phi_2753_ = _e3367;
phi_2756_ = _e3369;
break if !(_e1535);
}
}
let _e4271 = local_40;
phi_2557_ = _e4271;
phi_2560_ = (_e1359 + 1u);
} else {
phi_2557_ = vec3<f32>();
phi_2560_ = u32();
}
let _e3373 = phi_2557_;
let _e3375 = phi_2560_;
continue;
continuing {
phi_2556_ = _e3373;
phi_2559_ = _e3375;
break if !(_e1364);
}
}
let _e3384 = (1f / select(_e464, select(1e-12f, -1e-12f, (_e464 < 0f)), (bitcast<f32>((bitcast<u32>(_e464) & 2147483647u)) < 1e-12f)));
let _e3392 = (1f / select(_e475, select(1e-12f, -1e-12f, (_e475 < 0f)), (bitcast<f32>((bitcast<u32>(_e475) & 2147483647u)) < 1e-12f)));
let _e3400 = (1f / select(_e486, select(1e-12f, -1e-12f, (_e486 < 0f)), (bitcast<f32>((bitcast<u32>(_e486) & 2147483647u)) < 1e-12f)));
let _e3404 = global_1.member.member_13.member_4;
let _e3411 = global_1.member.member_13.member_5;
let _e3416 = ((_e3404.member - _e781) * _e3384);
let _e3418 = ((_e3411.member - _e781) * _e3384);
let _e3420 = ((_e3404.member_1 - _e782) * _e3392);
let _e3422 = ((_e3411.member_1 - _e782) * _e3392);
let _e3424 = ((_e3404.member_2 - _e783) * _e3400);
let _e3426 = ((_e3411.member_2 - _e783) * _e3400);
let _e3428 = select(_e3418, _e3416, (_e3416 < _e3418));
let _e3430 = select(_e3422, _e3420, (_e3420 < _e3422));
let _e3432 = select(_e3430, _e3428, (_e3428 > _e3430));
let _e3434 = select(_e3426, _e3424, (_e3424 < _e3426));
let _e3436 = select(_e3434, _e3432, (_e3432 > _e3434));
let _e3438 = select(_e3418, _e3416, (_e3416 > _e3418));
let _e3440 = select(_e3422, _e3420, (_e3420 > _e3422));
let _e3442 = select(_e3440, _e3438, (_e3438 < _e3440));
let _e3444 = select(_e3426, _e3424, (_e3424 > _e3426));
let _e3446 = select(_e3444, _e3442, (_e3442 < _e3444));
let _e3448 = select(0f, _e3436, (_e3436 > 0f));
let _e3450 = select(_e784, _e3446, (_e3446 < _e784));
let _e3451 = (_e3450 > _e3448);
let _e3452 = select(0f, _e3448, _e3451);
let _e3454 = (select(0f, _e3450, _e3451) - _e3452);
let _e3458 = global_1.member.member_13.member_6;
if (_e3458 == 0u) {
phi_6550_ = _e3454;
} else {
let _e3461 = (_e3454 / f32(_e3458));
phi_5837_ = 0u;
phi_5840_ = 0f;
loop {
let _e3463 = phi_5837_;
let _e3465 = phi_5840_;
local_41 = _e3465;
let _e3468 = ((_e3463 < _e3458) && (_e3454 > 0f));
if _e3468 {
let _e3471 = (_e3452 + (_e3461 * f32(_e3463)));
let _e3472 = (_e3471 + _e3461);
let _e3474 = (0.5f * (_e3471 + _e3472));
let _e3475 = (_e3472 - _e3471);
let _e3476 = (0.28867513f * _e3475);
let _e3477 = (_e3474 - _e3476);
let _e3487 = global_1.member.member_13.member_7;
let _e3488 = bitcast<i32>(_e3487);
let _e3492 = global_1.member.member_13.member_8;
let _e3493 = bitcast<i32>(_e3492);
let _e3497 = global_1.member.member_13.member_9;
let _e3498 = bitcast<i32>(_e3497);
let _e3499 = f32(_e3488);
let _e3501 = (_e3411.member - _e3404.member);
let _e3504 = (((((_e781 + (_e464 * _e3477)) - _e3404.member) / _e3501) * _e3499) - 0.5f);
let _e3505 = (_e3499 - 1f);
let _e3507 = select(0f, _e3504, (_e3504 > 0f));
let _e3509 = select(_e3505, _e3507, (_e3507 < _e3505));
let _e3510 = f32(_e3493);
let _e3512 = (_e3411.member_1 - _e3404.member_1);
let _e3515 = (((((_e782 + (_e475 * _e3477)) - _e3404.member_1) / _e3512) * _e3510) - 0.5f);
let _e3516 = (_e3510 - 1f);
let _e3518 = select(0f, _e3515, (_e3515 > 0f));
let _e3520 = select(_e3516, _e3518, (_e3518 < _e3516));
let _e3521 = f32(_e3498);
let _e3523 = (_e3411.member_2 - _e3404.member_2);
let _e3526 = (((((_e783 + (_e486 * _e3477)) - _e3404.member_2) / _e3523) * _e3521) - 0.5f);
let _e3527 = (_e3521 - 1f);
let _e3529 = select(0f, _e3526, (_e3526 > 0f));
let _e3531 = select(_e3527, _e3529, (_e3529 < _e3527));
let _e3533 = select(0f, _e3509, (_e3509 > 0f));
let _e3535 = select(1e6f, _e3533, (_e3533 < 1e6f));
let _e3542 = select(0i, select(select(i32(_e3535), i32(-2147483648), (_e3535 < -2147483600f)), 2147483647i, (_e3535 > 2147483500f)), (_e3535 == _e3535));
let _e3546 = (_e3542 - select(0i, 1i, (_e3535 < f32(_e3542))));
let _e3548 = select(0f, _e3520, (_e3520 > 0f));
let _e3550 = select(1e6f, _e3548, (_e3548 < 1e6f));
let _e3557 = select(0i, select(select(i32(_e3550), i32(-2147483648), (_e3550 < -2147483600f)), 2147483647i, (_e3550 > 2147483500f)), (_e3550 == _e3550));
let _e3561 = (_e3557 - select(0i, 1i, (_e3550 < f32(_e3557))));
let _e3563 = select(0f, _e3531, (_e3531 > 0f));
let _e3565 = select(1e6f, _e3563, (_e3563 < 1e6f));
let _e3572 = select(0i, select(select(i32(_e3565), i32(-2147483648), (_e3565 < -2147483600f)), 2147483647i, (_e3565 > 2147483500f)), (_e3565 == _e3565));
let _e3576 = (_e3572 - select(0i, 1i, (_e3565 < f32(_e3572))));
let _e3580 = (_e3520 - f32(_e3561));
let _e3582 = (_e3531 - f32(_e3576));
local_2 = (_e3509 - f32(_e3546));
let _e3583 = (_e3546 + 1i);
let _e3585 = select(_e3583, 0i, (_e3583 < 0i));
if (_e3585 >= _e3488) {
phi_5975_ = (_e3488 - 1i);
} else {
phi_5975_ = _e3585;
}
let _e3589 = phi_5975_;
local_3 = (_e3589 - _e3546);
let _e3591 = (_e3561 + 1i);
let _e3593 = select(_e3591, 0i, (_e3591 < 0i));
if (_e3593 >= _e3493) {
phi_5988_ = (_e3493 - 1i);
} else {
phi_5988_ = _e3593;
}
let _e3597 = phi_5988_;
let _e3599 = ((_e3597 - _e3561) * _e3488);
let _e3600 = (_e3576 + 1i);
let _e3602 = select(_e3600, 0i, (_e3600 < 0i));
if (_e3602 >= _e3498) {
phi_6002_ = (_e3498 - 1i);
} else {
phi_6002_ = _e3602;
}
let _e3606 = phi_6002_;
let _e3613 = global_1.member.member_13.member_10;
let _e3614 = bitcast<i32>(_e3613);
let _e3619 = ((_e3614 + (((_e3576 * _e3493) + _e3561) * _e3488)) + _e3546);
let _e3621 = select(_e1285, _e3619, (_e3619 < _e1285));
let _e3626 = global_8.member[bitcast<u32>(select(0i, _e3621, (_e3621 > 0i)))];
let _e3627 = local_2;
let _e3630 = local_3;
let _e3631 = (_e3619 + _e3630);
let _e3633 = select(_e1285, _e3631, (_e3631 < _e1285));
let _e3638 = global_8.member[bitcast<u32>(select(0i, _e3633, (_e3633 > 0i)))];
let _e3639 = local_2;
let _e3642 = (1f - _e3580);
let _e3644 = (_e3619 + _e3599);
let _e3646 = select(_e1285, _e3644, (_e3644 < _e1285));
let _e3651 = global_8.member[bitcast<u32>(select(0i, _e3646, (_e3646 > 0i)))];
let _e3652 = local_2;
let _e3655 = local_3;
let _e3656 = (_e3644 + _e3655);
let _e3658 = select(_e1285, _e3656, (_e3656 < _e1285));
let _e3663 = global_8.member[bitcast<u32>(select(0i, _e3658, (_e3658 > 0i)))];
let _e3664 = local_2;
let _e3669 = (_e3619 + (((_e3606 - _e3576) * _e3488) * _e3493));
let _e3671 = select(_e1285, _e3669, (_e3669 < _e1285));
let _e3676 = global_8.member[bitcast<u32>(select(0i, _e3671, (_e3671 > 0i)))];
let _e3677 = local_2;
let _e3680 = local_3;
let _e3681 = (_e3669 + _e3680);
let _e3683 = select(_e1285, _e3681, (_e3681 < _e1285));
let _e3688 = global_8.member[bitcast<u32>(select(0i, _e3683, (_e3683 > 0i)))];
let _e3689 = local_2;
let _e3693 = (_e3669 + _e3599);
let _e3695 = select(_e1285, _e3693, (_e3693 < _e1285));
let _e3700 = global_8.member[bitcast<u32>(select(0i, _e3695, (_e3695 > 0i)))];
let _e3701 = local_2;
let _e3704 = local_3;
let _e3705 = (_e3693 + _e3704);
let _e3707 = select(_e1285, _e3705, (_e3705 < _e1285));
let _e3712 = global_8.member[bitcast<u32>(select(0i, _e3707, (_e3707 > 0i)))];
let _e3713 = local_2;
let _e3722 = (_e3474 + _e3476);
let _e3732 = (((((_e781 + (_e464 * _e3722)) - _e3404.member) / _e3501) * _e3499) - 0.5f);
let _e3734 = select(0f, _e3732, (_e3732 > 0f));
let _e3736 = select(_e3505, _e3734, (_e3734 < _e3505));
let _e3740 = (((((_e782 + (_e475 * _e3722)) - _e3404.member_1) / _e3512) * _e3510) - 0.5f);
let _e3742 = select(0f, _e3740, (_e3740 > 0f));
let _e3744 = select(_e3516, _e3742, (_e3742 < _e3516));
let _e3748 = (((((_e783 + (_e486 * _e3722)) - _e3404.member_2) / _e3523) * _e3521) - 0.5f);
let _e3750 = select(0f, _e3748, (_e3748 > 0f));
let _e3752 = select(_e3527, _e3750, (_e3750 < _e3527));
let _e3754 = select(0f, _e3736, (_e3736 > 0f));
let _e3756 = select(1e6f, _e3754, (_e3754 < 1e6f));
let _e3763 = select(0i, select(select(i32(_e3756), i32(-2147483648), (_e3756 < -2147483600f)), 2147483647i, (_e3756 > 2147483500f)), (_e3756 == _e3756));
let _e3767 = (_e3763 - select(0i, 1i, (_e3756 < f32(_e3763))));
let _e3769 = select(0f, _e3744, (_e3744 > 0f));
let _e3771 = select(1e6f, _e3769, (_e3769 < 1e6f));
let _e3778 = select(0i, select(select(i32(_e3771), i32(-2147483648), (_e3771 < -2147483600f)), 2147483647i, (_e3771 > 2147483500f)), (_e3771 == _e3771));
let _e3782 = (_e3778 - select(0i, 1i, (_e3771 < f32(_e3778))));
let _e3784 = select(0f, _e3752, (_e3752 > 0f));
let _e3786 = select(1e6f, _e3784, (_e3784 < 1e6f));
let _e3793 = select(0i, select(select(i32(_e3786), i32(-2147483648), (_e3786 < -2147483600f)), 2147483647i, (_e3786 > 2147483500f)), (_e3786 == _e3786));
let _e3797 = (_e3793 - select(0i, 1i, (_e3786 < f32(_e3793))));
let _e3801 = (_e3744 - f32(_e3782));
let _e3803 = (_e3752 - f32(_e3797));
local = (_e3736 - f32(_e3767));
let _e3804 = (_e3767 + 1i);
let _e3806 = select(_e3804, 0i, (_e3804 < 0i));
if (_e3806 >= _e3488) {
phi_6318_ = (_e3488 - 1i);
} else {
phi_6318_ = _e3806;
}
let _e3810 = phi_6318_;
local_1 = (_e3810 - _e3767);
let _e3812 = (_e3782 + 1i);
let _e3814 = select(_e3812, 0i, (_e3812 < 0i));
if (_e3814 >= _e3493) {
phi_6331_ = (_e3493 - 1i);
} else {
phi_6331_ = _e3814;
}
let _e3818 = phi_6331_;
let _e3820 = ((_e3818 - _e3782) * _e3488);
let _e3821 = (_e3797 + 1i);
let _e3823 = select(_e3821, 0i, (_e3821 < 0i));
if (_e3823 >= _e3498) {
phi_6345_ = (_e3498 - 1i);
} else {
phi_6345_ = _e3823;
}
let _e3827 = phi_6345_;
let _e3835 = ((_e3614 + (((_e3797 * _e3493) + _e3782) * _e3488)) + _e3767);
let _e3837 = select(_e1285, _e3835, (_e3835 < _e1285));
let _e3842 = global_8.member[bitcast<u32>(select(0i, _e3837, (_e3837 > 0i)))];
let _e3843 = local;
let _e3846 = local_1;
let _e3847 = (_e3835 + _e3846);
let _e3849 = select(_e1285, _e3847, (_e3847 < _e1285));
let _e3854 = global_8.member[bitcast<u32>(select(0i, _e3849, (_e3849 > 0i)))];
let _e3855 = local;
let _e3858 = (1f - _e3801);
let _e3860 = (_e3835 + _e3820);
let _e3862 = select(_e1285, _e3860, (_e3860 < _e1285));
let _e3867 = global_8.member[bitcast<u32>(select(0i, _e3862, (_e3862 > 0i)))];
let _e3868 = local;
let _e3871 = local_1;
let _e3872 = (_e3860 + _e3871);
let _e3874 = select(_e1285, _e3872, (_e3872 < _e1285));
let _e3879 = global_8.member[bitcast<u32>(select(0i, _e3874, (_e3874 > 0i)))];
let _e3880 = local;
let _e3885 = (_e3835 + (((_e3827 - _e3797) * _e3488) * _e3493));
let _e3887 = select(_e1285, _e3885, (_e3885 < _e1285));
let _e3892 = global_8.member[bitcast<u32>(select(0i, _e3887, (_e3887 > 0i)))];
let _e3893 = local;
let _e3896 = local_1;
let _e3897 = (_e3885 + _e3896);
let _e3899 = select(_e1285, _e3897, (_e3897 < _e1285));
let _e3904 = global_8.member[bitcast<u32>(select(0i, _e3899, (_e3899 > 0i)))];
let _e3905 = local;
let _e3909 = (_e3885 + _e3820);
let _e3911 = select(_e1285, _e3909, (_e3909 < _e1285));
let _e3916 = global_8.member[bitcast<u32>(select(0i, _e3911, (_e3911 > 0i)))];
let _e3917 = local;
let _e3920 = local_1;
let _e3921 = (_e3909 + _e3920);
let _e3923 = select(_e1285, _e3921, (_e3921 < _e1285));
let _e3928 = global_8.member[bitcast<u32>(select(0i, _e3923, (_e3923 > 0i)))];
let _e3929 = local;
phi_5838_ = (_e3463 + 1u);
phi_5841_ = (_e3465 + ((0.5f * (((((((_e3626 * (1f - _e3627)) + (_e3638 * _e3639)) * _e3642) + (((_e3651 * (1f - _e3652)) + (_e3663 * _e3664)) * _e3580)) * (1f - _e3582)) + (((((_e3676 * (1f - _e3677)) + (_e3688 * _e3689)) * _e3642) + (((_e3700 * (1f - _e3701)) + (_e3712 * _e3713)) * _e3580)) * _e3582)) + ((((((_e3842 * (1f - _e3843)) + (_e3854 * _e3855)) * _e3858) + (((_e3867 * (1f - _e3868)) + (_e3879 * _e3880)) * _e3801)) * (1f - _e3803)) + (((((_e3892 * (1f - _e3893)) + (_e3904 * _e3905)) * _e3858) + (((_e3916 * (1f - _e3917)) + (_e3928 * _e3929)) * _e3801)) * _e3803)))) * _e3475));
} else {
phi_5838_ = u32();
phi_5841_ = f32();
}
let _e3944 = phi_5838_;
let _e3946 = phi_5841_;
continue;
continuing {
phi_5837_ = _e3944;
phi_5840_ = _e3946;
break if !(_e3468);
}
}
let _e4285 = local_41;
phi_6550_ = _e4285;
}
let _e3949 = phi_6550_;
let _e3953 = global_1.member.member_13.member;
let _e3958 = -((_e3953.member * _e3949));
let _e3960 = select(-87f, _e3958, (_e3958 > -87f));
let _e3962 = select(88f, _e3960, (_e3960 < 88f));
let _e3964 = ((_e3962 * 1.442695f) + 0.5f);
let _e3966 = select(-127f, _e3964, (_e3964 > -127f));
let _e3968 = select(128f, _e3966, (_e3966 < 128f));
let _e3975 = select(0i, select(select(i32(_e3968), i32(-2147483648), (_e3968 < -2147483600f)), 2147483647i, (_e3968 > 2147483500f)), (_e3968 == _e3968));
let _e3979 = (_e3975 - select(0i, 1i, (_e3968 < f32(_e3975))));
let _e3980 = f32(_e3979);
let _e3984 = ((_e3962 - (_e3980 * 0.6933594f)) - (_e3980 * -2.1219444e-4f));
let _e4006 = -((_e3953.member_1 * _e3949));
let _e4008 = select(-87f, _e4006, (_e4006 > -87f));
let _e4010 = select(88f, _e4008, (_e4008 < 88f));
let _e4012 = ((_e4010 * 1.442695f) + 0.5f);
let _e4014 = select(-127f, _e4012, (_e4012 > -127f));
let _e4016 = select(128f, _e4014, (_e4014 < 128f));
let _e4023 = select(0i, select(select(i32(_e4016), i32(-2147483648), (_e4016 < -2147483600f)), 2147483647i, (_e4016 > 2147483500f)), (_e4016 == _e4016));
let _e4027 = (_e4023 - select(0i, 1i, (_e4016 < f32(_e4023))));
let _e4028 = f32(_e4027);
let _e4032 = ((_e4010 - (_e4028 * 0.6933594f)) - (_e4028 * -2.1219444e-4f));
let _e4054 = -((_e3953.member_2 * _e3949));
let _e4056 = select(-87f, _e4054, (_e4054 > -87f));
let _e4058 = select(88f, _e4056, (_e4056 < 88f));
let _e4060 = ((_e4058 * 1.442695f) + 0.5f);
let _e4062 = select(-127f, _e4060, (_e4060 > -127f));
let _e4064 = select(128f, _e4062, (_e4062 < 128f));
let _e4071 = select(0i, select(select(i32(_e4064), i32(-2147483648), (_e4064 < -2147483600f)), 2147483647i, (_e4064 > 2147483500f)), (_e4064 == _e4064));
let _e4075 = (_e4071 - select(0i, 1i, (_e4064 < f32(_e4071))));
let _e4076 = f32(_e4075);
let _e4080 = ((_e4058 - (_e4076 * 0.6933594f)) - (_e4076 * -2.1219444e-4f));
let _e4103 = local_33;
let _e4108 = local_34;
let _e4113 = local_35;
phi_6786_ = array<f32, 19>(_e171, _e181, _e192, (_e203 + (((_e4103.x * _e1262.member_3.x) * ((1f + (_e3984 * (1f + (_e3984 * (0.5f + (_e3984 * (0.16666667f + (_e3984 * (0.041666668f + (_e3984 * (0.008333334f + (_e3984 * (0.001388889f + (_e3984 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3979 + 127i)) << bitcast<u32>(23i))))) * select(_e629, 1f, _e699))), (_e214 + (((_e4108.y * _e1262.member_3.y) * ((1f + (_e4032 * (1f + (_e4032 * (0.5f + (_e4032 * (0.16666667f + (_e4032 * (0.041666668f + (_e4032 * (0.008333334f + (_e4032 * (0.001388889f + (_e4032 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4027 + 127i)) << bitcast<u32>(23i))))) * select(_e640, 1f, _e699))), (_e225 + (((_e4113.z * _e1262.member_3.z) * ((1f + (_e4080 * (1f + (_e4080 * (0.5f + (_e4080 * (0.16666667f + (_e4080 * (0.041666668f + (_e4080 * (0.008333334f + (_e4080 * (0.001388889f + (_e4080 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4075 + 127i)) << bitcast<u32>(23i))))) * select(_e651, 1f, _e699))), _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357, _e368);
} else {
phi_6786_ = array<f32, 19>(_e171, _e181, _e192, _e203, _e214, _e225, _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357, _e368);
}
let _e4128 = phi_6786_;
global_5.member[_e160] = _e4128[0];
global_5.member[_e172] = _e4128[1];
global_5.member[_e183] = _e4128[2];
global_5.member[_e194] = _e4128[3];
global_5.member[_e205] = _e4128[4];
global_5.member[_e216] = _e4128[5];
global_5.member[_e227] = _e4128[6];
global_5.member[_e238] = _e4128[7];
global_5.member[_e249] = _e4128[8];
global_5.member[_e260] = _e4128[9];
global_5.member[_e271] = _e4128[10];
global_5.member[_e282] = _e4128[11];
global_5.member[_e293] = _e4128[12];
global_5.member[_e304] = _e4128[13];
global_5.member[_e315] = _e4128[14];
global_5.member[_e326] = _e4128[15];
global_5.member[_e337] = _e4128[16];
global_5.member[_e348] = _e4128[17];
global_5.member[_e359] = _e4128[18];
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
