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
var phi_2585_: vec3<f32>;
var phi_2588_: u32;
var phi_2608_: u32;
var phi_2609_: u32;
var phi_2621_: u32;
var phi_2622_: u32;
var local_20: u32;
var local_21: u32;
var phi_2639_: u32;
var phi_2640_: u32;
var phi_2652_: u32;
var phi_2653_: u32;
var local_22: u32;
var local_23: u32;
var local_24: u32;
var phi_2678_: u32;
var phi_2679_: u32;
var local_25: u32;
var local_26: u32;
var phi_2696_: u32;
var phi_2697_: u32;
var local_27: u32;
var local_28: u32;
var phi_2719_: u32;
var phi_2720_: u32;
var phi_2732_: u32;
var phi_2733_: u32;
var local_29: u32;
var local_30: u32;
var local_31: u32;
var phi_2769_: u32;
var local_32: u32;
var phi_2782_: vec3<f32>;
var phi_2785_: type_17;
var phi_3044_: u32;
var phi_3061_: u32;
var phi_3064_: u32;
var phi_3083_: u32;
var phi_3062_: u32;
var phi_3065_: u32;
var phi_3373_: u32;
var phi_3375_: vec3<f32>;
var phi_3378_: u32;
var phi_3407_: u32;
var phi_3453_: i32;
var phi_4958_: f32;
var phi_4981_: u32;
var phi_4984_: f32;
var phi_5119_: i32;
var phi_5132_: i32;
var phi_5146_: i32;
var phi_5462_: i32;
var phi_5475_: i32;
var phi_5489_: i32;
var phi_4982_: u32;
var phi_4985_: f32;
var phi_5694_: f32;
var phi_6027_: vec3<f32>;
var phi_6028_: vec3<f32>;
var phi_6029_: bool;
var phi_6033_: vec3<f32>;
var phi_6034_: bool;
var phi_6050_: vec3<f32>;
var phi_3376_: vec3<f32>;
var phi_3379_: u32;
var phi_6060_: type_17;
var phi_6061_: type_17;
var phi_6082_: vec3<f32>;
var phi_6083_: type_17;
var phi_2783_: vec3<f32>;
var phi_2786_: type_17;
var phi_2586_: vec3<f32>;
var phi_2589_: u32;
var phi_6232_: u32;
var phi_6235_: f32;
var phi_6370_: i32;
var phi_6383_: i32;
var phi_6397_: i32;
var phi_6713_: i32;
var phi_6726_: i32;
var phi_6740_: i32;
var phi_6233_: u32;
var phi_6236_: f32;
var phi_6945_: f32;
var local_33: vec3<f32>;
var local_34: vec3<f32>;
var local_35: vec3<f32>;
var phi_7181_: array<f32, 19>;
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
let _e1354 = (((_e1335 * _e1335) + (_e1336 * _e1336)) + (_e1337 * _e1337));
let _e1357 = sqrt(select(0f, _e1354, (_e1354 > 0f)));
let _e1362 = (((_e1347 * _e1347) + (_e1348 * _e1348)) + (_e1349 * _e1349));
let _e1365 = sqrt(select(0f, _e1362, (_e1362 > 0f)));
let _e1369 = (0.05f + (2f * select(_e1365, _e1357, (_e1357 > _e1365))));
let _e1373 = global_1.member.member_11.member;
phi_2585_ = vec3<f32>(0f, 0f, 0f);
phi_2588_ = 1u;
loop {
let _e1377 = phi_2585_;
let _e1379 = phi_2588_;
local_33 = _e1377;
local_34 = _e1377;
local_35 = _e1377;
let _e1383 = global_1.member.member_12.member_8;
let _e1384 = (_e1379 <= _e1383);
if _e1384 {
let _e1388 = global_1.member.member_12.member_5;
phi_2608_ = 0u;
loop {
let _e1392 = phi_2608_;
local_32 = _e1392;
let _e1396 = ((1u << bitcast<u32>((_e1392 & 31u))) < _e1373);
if _e1396 {
phi_2609_ = (_e1392 + 1u);
} else {
phi_2609_ = u32();
}
let _e1399 = phi_2609_;
continue;
continuing {
phi_2608_ = _e1399;
break if !(_e1396);
}
}
phi_2621_ = 0u;
loop {
let _e1402 = phi_2621_;
local_20 = _e1402;
local_21 = _e1402;
let _e1406 = ((1u << bitcast<u32>((_e1402 & 31u))) < _e1373);
if _e1406 {
phi_2622_ = (_e1402 + 1u);
} else {
phi_2622_ = u32();
}
let _e1409 = phi_2622_;
continue;
continuing {
phi_2621_ = _e1409;
break if !(_e1406);
}
}
let _e1412 = local_20;
let _e1415 = local_21;
phi_2639_ = 0u;
loop {
let _e1418 = phi_2639_;
local_24 = _e1418;
let _e1422 = ((1u << bitcast<u32>((_e1418 & 31u))) < _e1373);
if _e1422 {
phi_2640_ = (_e1418 + 1u);
} else {
phi_2640_ = u32();
}
let _e1425 = phi_2640_;
continue;
continuing {
phi_2639_ = _e1425;
break if !(_e1422);
}
}
phi_2652_ = 0u;
loop {
let _e1428 = phi_2652_;
local_22 = _e1428;
local_23 = _e1428;
let _e1432 = ((1u << bitcast<u32>((_e1428 & 31u))) < _e1373);
if _e1432 {
phi_2653_ = (_e1428 + 1u);
} else {
phi_2653_ = u32();
}
let _e1435 = phi_2653_;
continue;
continuing {
phi_2652_ = _e1435;
break if !(_e1432);
}
}
let _e1438 = local_22;
let _e1441 = local_23;
let _e1444 = local_24;
let _e1453 = global_1.member.member_12.member_7;
phi_2678_ = 0u;
loop {
let _e1456 = phi_2678_;
local_25 = _e1456;
local_26 = _e1456;
let _e1460 = ((1u << bitcast<u32>((_e1456 & 31u))) < _e1373);
if _e1460 {
phi_2679_ = (_e1456 + 1u);
} else {
phi_2679_ = u32();
}
let _e1463 = phi_2679_;
continue;
continuing {
phi_2678_ = _e1463;
break if !(_e1460);
}
}
let _e1466 = local_25;
let _e1469 = local_26;
phi_2696_ = 0u;
loop {
let _e1472 = phi_2696_;
local_27 = _e1472;
local_28 = _e1472;
let _e1476 = ((1u << bitcast<u32>((_e1472 & 31u))) < _e1373);
if _e1476 {
phi_2697_ = (_e1472 + 1u);
} else {
phi_2697_ = u32();
}
let _e1479 = phi_2697_;
continue;
continuing {
phi_2696_ = _e1479;
break if !(_e1476);
}
}
let _e1482 = local_27;
let _e1488 = local_28;
phi_2719_ = 0u;
loop {
let _e1498 = phi_2719_;
local_31 = _e1498;
let _e1502 = ((1u << bitcast<u32>((_e1498 & 31u))) < _e1373);
if _e1502 {
phi_2720_ = (_e1498 + 1u);
} else {
phi_2720_ = u32();
}
let _e1505 = phi_2720_;
continue;
continuing {
phi_2719_ = _e1505;
break if !(_e1502);
}
}
phi_2732_ = 0u;
loop {
let _e1508 = phi_2732_;
local_29 = _e1508;
local_30 = _e1508;
let _e1512 = ((1u << bitcast<u32>((_e1508 & 31u))) < _e1373);
if _e1512 {
phi_2733_ = (_e1508 + 1u);
} else {
phi_2733_ = u32();
}
let _e1515 = phi_2733_;
continue;
continuing {
phi_2732_ = _e1515;
break if !(_e1512);
}
}
let _e1518 = local_29;
let _e1521 = local_30;
let _e1524 = local_31;
let _e1530 = (((((1u << bitcast<u32>(((2u * _e1482) & 31u))) - (1u << bitcast<u32>(((2u * (_e1488 - select(6u, _e1469, (_e1466 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1524 - select(6u, _e1521, (_e1518 < 6u)))) & 31u))));
let _e1531 = (_e1530 / 64u);
if ((_e1530 % 64u) > 0u) {
phi_2769_ = (_e1531 + 1u);
} else {
phi_2769_ = _e1531;
}
let _e1536 = phi_2769_;
let _e1539 = local_32;
local_17 = type_24(_e1539, select(6u, _e1415, (_e1412 < 6u)), (1u << bitcast<u32>(((2u * (_e1444 - select(6u, _e1441, (_e1438 < 6u)))) & 31u))), (_e1379 * _e1453), (_e1536 * 64u));
let _e1542 = local_17.member_1;
phi_2782_ = _e1377;
phi_2785_ = type_17(_e1542, 0u);
loop {
let _e1545 = phi_2782_;
let _e1547 = phi_2785_;
local_40 = _e1545;
let _e1550 = local_17.member_1;
let _e1553 = local_17.member_2;
let _e1555 = ((_e1547.member < _e1550) || (_e1547.member_1 < _e1553));
if _e1555 {
local_15.member = _e1547.member;
local_15.member_1 = _e1547.member_1;
let _e1559 = local_15.member;
let _e1560 = local_15.member_1;
let _e1562 = local_17.member;
let _e1577 = local_17.member_3;
let _e1579 = local_17.member_4;
local_16 = ((_e1577 + (18u * _e1579)) + (((((1u << bitcast<u32>(((2u * _e1562) & 31u))) - (1u << bitcast<u32>(((2u * (_e1562 - _e1559)) & 31u)))) / 3u) * 4u) + _e1560));
let _e1583 = local_16;
let _e1584 = bitcast<i32>(_e1583);
let _e1586 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1588 = select(_e1586, _e1584, (_e1584 < _e1586));
let _e1593 = global_4.member[bitcast<u32>(select(0i, _e1588, (_e1588 > 0i)))];
let _e1594 = local_16;
let _e1595 = local_17.member_4;
let _e1597 = bitcast<i32>((_e1594 + _e1595));
let _e1599 = select(_e1586, _e1597, (_e1597 < _e1586));
let _e1604 = global_4.member[bitcast<u32>(select(0i, _e1599, (_e1599 > 0i)))];
let _e1605 = local_16;
let _e1606 = local_17.member_4;
let _e1609 = bitcast<i32>((_e1605 + (2u * _e1606)));
let _e1611 = select(_e1586, _e1609, (_e1609 < _e1586));
let _e1616 = global_4.member[bitcast<u32>(select(0i, _e1611, (_e1611 > 0i)))];
let _e1617 = local_15.member;
let _e1618 = local_15.member_1;
let _e1619 = local_17.member;
let _e1633 = local_17.member_3;
let _e1634 = local_17.member_4;
local_14 = ((_e1633 + (21u * _e1634)) + (((((1u << bitcast<u32>(((2u * _e1619) & 31u))) - (1u << bitcast<u32>(((2u * (_e1619 - _e1617)) & 31u)))) / 3u) * 4u) + _e1618));
let _e1638 = local_14;
let _e1639 = bitcast<i32>(_e1638);
let _e1641 = select(_e1586, _e1639, (_e1639 < _e1586));
let _e1646 = global_4.member[bitcast<u32>(select(0i, _e1641, (_e1641 > 0i)))];
let _e1647 = local_14;
let _e1648 = local_17.member_4;
let _e1650 = bitcast<i32>((_e1647 + _e1648));
let _e1652 = select(_e1586, _e1650, (_e1650 < _e1586));
let _e1657 = global_4.member[bitcast<u32>(select(0i, _e1652, (_e1652 > 0i)))];
let _e1658 = local_14;
let _e1659 = local_17.member_4;
let _e1662 = bitcast<i32>((_e1658 + (2u * _e1659)));
let _e1664 = select(_e1586, _e1662, (_e1662 < _e1586));
let _e1669 = global_4.member[bitcast<u32>(select(0i, _e1664, (_e1664 > 0i)))];
let _e1691 = ((((_e1593 <= _e1646) && ((_e1262.member.x >= (_e1593 - _e1369)) && (_e1262.member.x <= (_e1646 + _e1369)))) && ((_e1262.member.y >= (_e1604 - _e1369)) && (_e1262.member.y <= (_e1657 + _e1369)))) && ((_e1262.member.z >= (_e1616 - _e1369)) && (_e1262.member.z <= (_e1669 + _e1369))));
let _e1692 = local_17.member_1;
if (_e1692 < 2u) {
let _e1694 = local_17.member_1;
phi_3044_ = _e1694;
} else {
phi_3044_ = 2u;
}
let _e1696 = phi_3044_;
if (_e1691 && (_e1547.member > _e1696)) {
phi_6082_ = _e1545;
phi_6083_ = type_17((_e1547.member - 1u), (_e1547.member_1 << bitcast<u32>(2i)));
} else {
if _e1691 {
phi_3061_ = 0u;
phi_3064_ = 0u;
loop {
let _e1700 = phi_3061_;
let _e1702 = phi_3064_;
local_36 = _e1702;
let _e1703 = (_e1700 < 16u);
if _e1703 {
let _e1704 = local_17.member_1;
if (_e1704 < 2u) {
let _e1706 = local_17.member_1;
phi_3083_ = _e1706;
} else {
phi_3083_ = 2u;
}
let _e1708 = phi_3083_;
let _e1710 = ((2u * _e1708) & 31u);
let _e1713 = ((_e1547.member_1 << bitcast<u32>(_e1710)) + _e1700);
let _e1714 = (_e1713 & 1431655765u);
let _e1718 = ((_e1714 | (_e1714 >> bitcast<u32>(1i))) & 858993459u);
let _e1722 = ((_e1718 | (_e1718 >> bitcast<u32>(2i))) & 252645135u);
let _e1726 = ((_e1722 | (_e1722 >> bitcast<u32>(4i))) & 16711935u);
let _e1733 = ((_e1713 >> bitcast<u32>(1i)) & 1431655765u);
let _e1737 = ((_e1733 | (_e1733 >> bitcast<u32>(1i))) & 858993459u);
let _e1741 = ((_e1737 | (_e1737 >> bitcast<u32>(2i))) & 252645135u);
let _e1745 = ((_e1741 | (_e1741 >> bitcast<u32>(4i))) & 16711935u);
local_12.member = 0u;
local_12.member_1 = _e1713;
let _e1759 = local_12.member;
let _e1760 = local_12.member_1;
let _e1761 = local_17.member;
let _e1775 = local_17.member_3;
let _e1776 = local_17.member_4;
local_13 = ((_e1775 + (18u * _e1776)) + (((((1u << bitcast<u32>(((2u * _e1761) & 31u))) - (1u << bitcast<u32>(((2u * (_e1761 - _e1759)) & 31u)))) / 3u) * 4u) + _e1760));
let _e1780 = local_13;
let _e1781 = bitcast<i32>(_e1780);
let _e1783 = select(_e1586, _e1781, (_e1781 < _e1586));
let _e1788 = global_4.member[bitcast<u32>(select(0i, _e1783, (_e1783 > 0i)))];
let _e1789 = local_13;
let _e1790 = local_17.member_4;
let _e1792 = bitcast<i32>((_e1789 + _e1790));
let _e1794 = select(_e1586, _e1792, (_e1792 < _e1586));
let _e1799 = global_4.member[bitcast<u32>(select(0i, _e1794, (_e1794 > 0i)))];
let _e1800 = local_13;
let _e1801 = local_17.member_4;
let _e1804 = bitcast<i32>((_e1800 + (2u * _e1801)));
let _e1806 = select(_e1586, _e1804, (_e1804 < _e1586));
let _e1811 = global_4.member[bitcast<u32>(select(0i, _e1806, (_e1806 > 0i)))];
let _e1812 = local_12.member;
let _e1813 = local_12.member_1;
let _e1814 = local_17.member;
let _e1828 = local_17.member_3;
let _e1829 = local_17.member_4;
local_11 = ((_e1828 + (21u * _e1829)) + (((((1u << bitcast<u32>(((2u * _e1814) & 31u))) - (1u << bitcast<u32>(((2u * (_e1814 - _e1812)) & 31u)))) / 3u) * 4u) + _e1813));
let _e1833 = local_11;
let _e1834 = bitcast<i32>(_e1833);
let _e1836 = select(_e1586, _e1834, (_e1834 < _e1586));
let _e1841 = global_4.member[bitcast<u32>(select(0i, _e1836, (_e1836 > 0i)))];
let _e1842 = local_11;
let _e1843 = local_17.member_4;
let _e1845 = bitcast<i32>((_e1842 + _e1843));
let _e1847 = select(_e1586, _e1845, (_e1845 < _e1586));
let _e1852 = global_4.member[bitcast<u32>(select(0i, _e1847, (_e1847 > 0i)))];
let _e1853 = local_11;
let _e1854 = local_17.member_4;
let _e1857 = bitcast<i32>((_e1853 + (2u * _e1854)));
let _e1859 = select(_e1586, _e1857, (_e1857 < _e1586));
let _e1864 = global_4.member[bitcast<u32>(select(0i, _e1859, (_e1859 > 0i)))];
phi_3062_ = (_e1700 + 1u);
phi_3065_ = (_e1702 | (select(0u, 1u, ((((_e1700 < (1u << bitcast<u32>(_e1710))) && (((_e1726 | (_e1726 >> bitcast<u32>(8i))) & 65535u) < _e1373)) && (((_e1745 | (_e1745 >> bitcast<u32>(8i))) & 65535u) < _e1373)) && ((((_e1788 <= _e1841) && ((_e1262.member.x >= (_e1788 - _e1369)) && (_e1262.member.x <= (_e1841 + _e1369)))) && ((_e1262.member.y >= (_e1799 - _e1369)) && (_e1262.member.y <= (_e1852 + _e1369)))) && ((_e1262.member.z >= (_e1811 - _e1369)) && (_e1262.member.z <= (_e1864 + _e1369)))))) << bitcast<u32>((_e1700 & 31u))));
} else {
phi_3062_ = u32();
phi_3065_ = u32();
}
let _e1892 = phi_3062_;
let _e1894 = phi_3065_;
continue;
continuing {
phi_3061_ = _e1892;
phi_3064_ = _e1894;
break if !(_e1703);
}
}
let _e4486 = local_36;
phi_3373_ = _e4486;
} else {
phi_3373_ = 0u;
}
let _e1897 = phi_3373_;
phi_3375_ = _e1545;
phi_3378_ = 0u;
loop {
let _e1899 = phi_3375_;
let _e1901 = phi_3378_;
local_38 = _e1899;
let _e1904 = (_e1897 >> bitcast<u32>((_e1901 & 31u)));
let _e1905 = (_e1904 == 0u);
if _e1905 {
phi_3376_ = vec3<f32>();
phi_3379_ = u32();
} else {
if ((_e1904 & 1u) == 0u) {
phi_6050_ = _e1899;
} else {
let _e1908 = local_17.member_1;
if (_e1908 < 2u) {
let _e1910 = local_17.member_1;
phi_3407_ = _e1910;
} else {
phi_3407_ = 2u;
}
let _e1912 = phi_3407_;
let _e1914 = ((2u * _e1912) & 31u);
let _e1917 = ((_e1547.member_1 << bitcast<u32>(_e1914)) + _e1901);
let _e1918 = (_e1917 & 1431655765u);
let _e1922 = ((_e1918 | (_e1918 >> bitcast<u32>(1i))) & 858993459u);
let _e1926 = ((_e1922 | (_e1922 >> bitcast<u32>(2i))) & 252645135u);
let _e1930 = ((_e1926 | (_e1926 >> bitcast<u32>(4i))) & 16711935u);
let _e1934 = ((_e1930 | (_e1930 >> bitcast<u32>(8i))) & 65535u);
let _e1937 = ((_e1917 >> bitcast<u32>(1i)) & 1431655765u);
let _e1941 = ((_e1937 | (_e1937 >> bitcast<u32>(1i))) & 858993459u);
let _e1945 = ((_e1941 | (_e1941 >> bitcast<u32>(2i))) & 252645135u);
let _e1949 = ((_e1945 | (_e1945 >> bitcast<u32>(4i))) & 16711935u);
let _e1953 = ((_e1949 | (_e1949 >> bitcast<u32>(8i))) & 65535u);
if (((_e1901 < (1u << bitcast<u32>(_e1914))) && (_e1934 < _e1373)) && (_e1953 < _e1373)) {
phi_3453_ = bitcast<i32>(((_e1953 * _e1373) + _e1934));
} else {
phi_3453_ = 0i;
}
let _e1965 = phi_3453_;
local_8 = bitcast<i32>((_e1379 * _e1388));
local_9 = _e1965;
local_10 = bitcast<i32>((_e1373 * _e1373));
let _e1966 = local_8;
let _e1967 = local_9;
let _e1968 = (_e1966 + _e1967);
let _e1970 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e1972 = select(_e1970, _e1968, (_e1968 < _e1970));
let _e1977 = global_3.member[bitcast<u32>(select(0i, _e1972, (_e1972 > 0i)))];
let _e1978 = local_8;
let _e1979 = local_10;
let _e1981 = local_9;
let _e1982 = ((_e1978 + _e1979) + _e1981);
let _e1984 = select(_e1970, _e1982, (_e1982 < _e1970));
let _e1989 = global_3.member[bitcast<u32>(select(0i, _e1984, (_e1984 > 0i)))];
let _e1990 = local_8;
let _e1991 = local_10;
let _e1994 = local_9;
let _e1995 = ((_e1990 + (2i * _e1991)) + _e1994);
let _e1997 = select(_e1970, _e1995, (_e1995 < _e1970));
let _e2002 = global_3.member[bitcast<u32>(select(0i, _e1997, (_e1997 > 0i)))];
let _e2003 = local_8;
let _e2004 = local_10;
let _e2007 = local_9;
let _e2008 = ((_e2003 + (3i * _e2004)) + _e2007);
let _e2010 = select(_e1970, _e2008, (_e2008 < _e1970));
let _e2015 = global_3.member[bitcast<u32>(select(0i, _e2010, (_e2010 > 0i)))];
let _e2016 = local_8;
let _e2017 = local_10;
let _e2020 = local_9;
let _e2021 = ((_e2016 + (4i * _e2017)) + _e2020);
let _e2023 = select(_e1970, _e2021, (_e2021 < _e1970));
let _e2028 = global_3.member[bitcast<u32>(select(0i, _e2023, (_e2023 > 0i)))];
let _e2029 = local_8;
let _e2030 = local_10;
let _e2033 = local_9;
let _e2034 = ((_e2029 + (5i * _e2030)) + _e2033);
let _e2036 = select(_e1970, _e2034, (_e2034 < _e1970));
let _e2041 = global_3.member[bitcast<u32>(select(0i, _e2036, (_e2036 > 0i)))];
let _e2042 = local_8;
let _e2043 = local_10;
let _e2046 = local_9;
let _e2047 = ((_e2042 + (6i * _e2043)) + _e2046);
let _e2049 = select(_e1970, _e2047, (_e2047 < _e1970));
let _e2054 = global_3.member[bitcast<u32>(select(0i, _e2049, (_e2049 > 0i)))];
let _e2055 = local_8;
let _e2056 = local_10;
let _e2059 = local_9;
let _e2060 = ((_e2055 + (7i * _e2056)) + _e2059);
let _e2062 = select(_e1970, _e2060, (_e2060 < _e1970));
let _e2067 = global_3.member[bitcast<u32>(select(0i, _e2062, (_e2062 > 0i)))];
let _e2068 = local_8;
let _e2069 = local_10;
let _e2072 = local_9;
let _e2073 = ((_e2068 + (8i * _e2069)) + _e2072);
let _e2075 = select(_e1970, _e2073, (_e2073 < _e1970));
let _e2080 = global_3.member[bitcast<u32>(select(0i, _e2075, (_e2075 > 0i)))];
let _e2081 = local_8;
let _e2082 = local_10;
let _e2085 = local_9;
let _e2086 = ((_e2081 + (9i * _e2082)) + _e2085);
let _e2088 = select(_e1970, _e2086, (_e2086 < _e1970));
let _e2093 = global_3.member[bitcast<u32>(select(0i, _e2088, (_e2088 > 0i)))];
let _e2094 = local_8;
let _e2095 = local_10;
let _e2098 = local_9;
let _e2099 = ((_e2094 + (10i * _e2095)) + _e2098);
let _e2101 = select(_e1970, _e2099, (_e2099 < _e1970));
let _e2106 = global_3.member[bitcast<u32>(select(0i, _e2101, (_e2101 > 0i)))];
let _e2107 = local_8;
let _e2108 = local_10;
let _e2111 = local_9;
let _e2112 = ((_e2107 + (11i * _e2108)) + _e2111);
let _e2114 = select(_e1970, _e2112, (_e2112 < _e1970));
let _e2119 = global_3.member[bitcast<u32>(select(0i, _e2114, (_e2114 > 0i)))];
let _e2120 = local_8;
let _e2121 = local_10;
let _e2124 = local_9;
let _e2125 = ((_e2120 + (12i * _e2121)) + _e2124);
let _e2127 = select(_e1970, _e2125, (_e2125 < _e1970));
let _e2132 = global_3.member[bitcast<u32>(select(0i, _e2127, (_e2127 > 0i)))];
let _e2133 = local_8;
let _e2134 = local_10;
let _e2137 = local_9;
let _e2138 = ((_e2133 + (13i * _e2134)) + _e2137);
let _e2140 = select(_e1970, _e2138, (_e2138 < _e1970));
let _e2145 = global_3.member[bitcast<u32>(select(0i, _e2140, (_e2140 > 0i)))];
let _e2146 = local_8;
let _e2147 = local_10;
let _e2150 = local_9;
let _e2151 = ((_e2146 + (14i * _e2147)) + _e2150);
let _e2153 = select(_e1970, _e2151, (_e2151 < _e1970));
let _e2158 = global_3.member[bitcast<u32>(select(0i, _e2153, (_e2153 > 0i)))];
let _e2159 = local_8;
let _e2160 = local_10;
let _e2163 = local_9;
let _e2164 = ((_e2159 + (15i * _e2160)) + _e2163);
let _e2166 = select(_e1970, _e2164, (_e2164 < _e1970));
let _e2171 = global_3.member[bitcast<u32>(select(0i, _e2166, (_e2166 > 0i)))];
let _e2172 = local_8;
let _e2173 = local_10;
let _e2176 = local_9;
let _e2177 = ((_e2172 + (16i * _e2173)) + _e2176);
let _e2179 = select(_e1970, _e2177, (_e2177 < _e1970));
let _e2184 = global_3.member[bitcast<u32>(select(0i, _e2179, (_e2179 > 0i)))];
let _e2185 = local_8;
let _e2186 = local_10;
let _e2189 = local_9;
let _e2190 = ((_e2185 + (17i * _e2186)) + _e2189);
let _e2192 = select(_e1970, _e2190, (_e2190 < _e1970));
let _e2197 = global_3.member[bitcast<u32>(select(0i, _e2192, (_e2192 > 0i)))];
let _e2198 = local_8;
let _e2199 = local_10;
let _e2202 = local_9;
let _e2203 = ((_e2198 + (18i * _e2199)) + _e2202);
let _e2205 = select(_e1970, _e2203, (_e2203 < _e1970));
let _e2210 = global_3.member[bitcast<u32>(select(0i, _e2205, (_e2205 > 0i)))];
let _e2211 = local_8;
let _e2212 = local_10;
let _e2215 = local_9;
let _e2216 = ((_e2211 + (19i * _e2212)) + _e2215);
let _e2218 = select(_e1970, _e2216, (_e2216 < _e1970));
let _e2223 = global_3.member[bitcast<u32>(select(0i, _e2218, (_e2218 > 0i)))];
let _e2224 = local_8;
let _e2225 = local_10;
let _e2228 = local_9;
let _e2229 = ((_e2224 + (20i * _e2225)) + _e2228);
let _e2231 = select(_e1970, _e2229, (_e2229 < _e1970));
let _e2236 = global_3.member[bitcast<u32>(select(0i, _e2231, (_e2231 > 0i)))];
let _e2237 = local_8;
let _e2238 = local_10;
let _e2241 = local_9;
let _e2242 = ((_e2237 + (23i * _e2238)) + _e2241);
let _e2244 = select(_e1970, _e2242, (_e2242 < _e1970));
let _e2249 = global_3.member[bitcast<u32>(select(0i, _e2244, (_e2244 > 0i)))];
let _e2250 = local_8;
let _e2251 = local_10;
let _e2254 = local_9;
let _e2255 = ((_e2250 + (24i * _e2251)) + _e2254);
let _e2257 = select(_e1970, _e2255, (_e2255 < _e1970));
let _e2262 = global_3.member[bitcast<u32>(select(0i, _e2257, (_e2257 > 0i)))];
let _e2267 = (((_e1262.member_1.x * _e2015) + (_e1262.member_1.y * _e2028)) + (_e1262.member_1.z * _e2041));
let _e2270 = bitcast<f32>((bitcast<u32>(_e2267) & 2147483647u));
if (_e2270 < 1e-6f) {
phi_6033_ = vec3<f32>();
phi_6034_ = true;
} else {
let _e2272 = (1f / _e2267);
let _e2281 = ((((_e1262.member_1.x * (_e1262.member.x - _e1977)) + (_e1262.member_1.y * (_e1262.member.y - _e1989))) + (_e1262.member_1.z * (_e1262.member.z - _e2002))) * _e2272);
let _e2285 = (_e2054 + (_e2132 * _e2281));
let _e2286 = (_e2067 + (_e2145 * _e2281));
let _e2287 = (_e2080 + (_e2158 * _e2281));
let _e2293 = ((((_e1262.member_1.x * _e2285) + (_e1262.member_1.y * _e2286)) + (_e1262.member_1.z * _e2287)) * _e2272);
let _e2297 = (_e2285 - (_e2015 * _e2293));
let _e2298 = (_e2286 - (_e2028 * _e2293));
let _e2299 = (_e2287 - (_e2041 * _e2293));
let _e2303 = (_e2093 + (_e2171 * _e2281));
let _e2304 = (_e2106 + (_e2184 * _e2281));
let _e2305 = (_e2119 + (_e2197 * _e2281));
let _e2311 = ((((_e1262.member_1.x * _e2303) + (_e1262.member_1.y * _e2304)) + (_e1262.member_1.z * _e2305)) * _e2272);
let _e2315 = (_e2303 - (_e2015 * _e2311));
let _e2316 = (_e2304 - (_e2028 * _e2311));
let _e2317 = (_e2305 - (_e2041 * _e2311));
let _e2353 = (((0.5f * (bitcast<f32>((bitcast<u32>((((_e2297 * _e2015) + (_e2298 * _e2028)) + (_e2299 * _e2041))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((((_e2315 * _e2015) + (_e2316 * _e2028)) + (_e2317 * _e2041))) & 2147483647u)))) + bitcast<f32>((bitcast<u32>((((_e1335 * _e2015) + (_e1336 * _e2028)) + (_e1337 * _e2041))) & 2147483647u))) + bitcast<f32>((bitcast<u32>((((_e1347 * _e2015) + (_e1348 * _e2028)) + (_e1349 * _e2041))) & 2147483647u)));
if ((_e2281 < (-(0.05f) - _e2353)) || (bitcast<f32>((bitcast<u32>((_e2281 - _e2262)) & 2147483647u)) > (_e2353 + 0.05f))) {
phi_6028_ = vec3<f32>();
phi_6029_ = true;
} else {
let _e2370 = (_e1262.member.x - (_e1977 + (_e2015 * _e2281)));
let _e2371 = (_e1262.member.y - (_e1989 + (_e2028 * _e2281)));
let _e2372 = (_e1262.member.z - (_e2002 + (_e2041 * _e2281)));
let _e2386 = (((((_e2298 * _e2317) - (_e2299 * _e2316)) * _e1262.member_1.x) + (((_e2299 * _e2315) - (_e2297 * _e2317)) * _e1262.member_1.y)) + (((_e2297 * _e2316) - (_e2298 * _e2315)) * _e1262.member_1.z));
let _e2394 = (((_e2297 * _e2297) + (_e2298 * _e2298)) + (_e2299 * _e2299));
let _e2397 = sqrt(select(0f, _e2394, (_e2394 > 0f)));
let _e2402 = (((_e2315 * _e2315) + (_e2316 * _e2316)) + (_e2317 * _e2317));
let _e2405 = sqrt(select(0f, _e2402, (_e2402 > 0f)));
if (bitcast<f32>((bitcast<u32>(_e2386) & 2147483647u)) > ((0.5f * _e2397) * _e2405)) {
let _e2617 = (1f / _e2386);
let _e2632 = ((((((_e2371 * _e2317) - (_e2372 * _e2316)) * _e1262.member_1.x) + (((_e2372 * _e2315) - (_e2370 * _e2317)) * _e1262.member_1.y)) + (((_e2370 * _e2316) - (_e2371 * _e2315)) * _e1262.member_1.z)) * _e2617);
let _e2647 = ((((((_e2298 * _e2372) - (_e2299 * _e2371)) * _e1262.member_1.x) + (((_e2299 * _e2370) - (_e2297 * _e2372)) * _e1262.member_1.y)) + (((_e2297 * _e2371) - (_e2298 * _e2370)) * _e1262.member_1.z)) * _e2617);
let _e2710 = bitcast<f32>((bitcast<u32>(((((((_e1336 * _e2317) - (_e1337 * _e2316)) * _e1262.member_1.x) + (((_e1337 * _e2315) - (_e1335 * _e2317)) * _e1262.member_1.y)) + (((_e1335 * _e2316) - (_e1336 * _e2315)) * _e1262.member_1.z)) * _e2617)) & 2147483647u));
let _e2713 = bitcast<f32>((bitcast<u32>(((((((_e1348 * _e2317) - (_e1349 * _e2316)) * _e1262.member_1.x) + (((_e1349 * _e2315) - (_e1347 * _e2317)) * _e1262.member_1.y)) + (((_e1347 * _e2316) - (_e1348 * _e2315)) * _e1262.member_1.z)) * _e2617)) & 2147483647u));
let _e2715 = select(_e2713, _e2710, (_e2710 > _e2713));
let _e2717 = select(1e-3f, _e2715, (_e2715 > 1e-3f));
let _e2720 = bitcast<f32>((bitcast<u32>(((((((_e2298 * _e1337) - (_e2299 * _e1336)) * _e1262.member_1.x) + (((_e2299 * _e1335) - (_e2297 * _e1337)) * _e1262.member_1.y)) + (((_e2297 * _e1336) - (_e2298 * _e1335)) * _e1262.member_1.z)) * _e2617)) & 2147483647u));
let _e2723 = bitcast<f32>((bitcast<u32>(((((((_e2298 * _e1349) - (_e2299 * _e1348)) * _e1262.member_1.x) + (((_e2299 * _e1347) - (_e2297 * _e1349)) * _e1262.member_1.y)) + (((_e2297 * _e1348) - (_e2298 * _e1347)) * _e1262.member_1.z)) * _e2617)) & 2147483647u));
let _e2725 = select(_e2723, _e2720, (_e2720 > _e2723));
let _e2727 = select(1e-3f, _e2725, (_e2725 > 1e-3f));
let _e2728 = (1e-4f * _e2717);
let _e2730 = select(_e2728, 1f, (1f > _e2728));
let _e2732 = select(_e2728, 0f, (0f > _e2728));
let _e2734 = (0.5f * (_e2730 + _e2732));
let _e2735 = (0.5f / _e2732);
let _e2736 = (1f / _e2730);
let _e2738 = (0.5f * _e2717);
let _e2739 = (_e2632 + _e2738);
let _e2740 = -(_e2739);
let _e2743 = (_e2734 - select(_e2740, _e2739, (_e2739 > _e2740)));
let _e2745 = select(0f, _e2743, (_e2743 > 0f));
let _e2747 = select(_e2732, _e2745, (_e2745 < _e2732));
let _e2750 = (_e2743 - _e2732);
let _e2754 = (((_e2747 * (_e2747 * _e2735)) + select(0f, _e2750, (_e2750 > 0f))) * _e2736);
let _e2758 = (_e2632 - _e2738);
let _e2759 = -(_e2758);
let _e2762 = (_e2734 - select(_e2759, _e2758, (_e2758 > _e2759)));
let _e2764 = select(0f, _e2762, (_e2762 > 0f));
let _e2766 = select(_e2732, _e2764, (_e2764 < _e2732));
let _e2769 = (_e2762 - _e2732);
let _e2773 = (((_e2766 * (_e2766 * _e2735)) + select(0f, _e2769, (_e2769 > 0f))) * _e2736);
let _e2779 = (1e-4f * _e2727);
let _e2781 = select(_e2779, 1f, (1f > _e2779));
let _e2783 = select(_e2779, 0f, (0f > _e2779));
let _e2785 = (0.5f * (_e2781 + _e2783));
let _e2786 = (0.5f / _e2783);
let _e2787 = (1f / _e2781);
let _e2789 = (0.5f * _e2727);
let _e2790 = (_e2647 + _e2789);
let _e2791 = -(_e2790);
let _e2794 = (_e2785 - select(_e2791, _e2790, (_e2790 > _e2791)));
let _e2796 = select(0f, _e2794, (_e2794 > 0f));
let _e2798 = select(_e2783, _e2796, (_e2796 < _e2783));
let _e2801 = (_e2794 - _e2783);
let _e2805 = (((_e2798 * (_e2798 * _e2786)) + select(0f, _e2801, (_e2801 > 0f))) * _e2787);
let _e2809 = (_e2647 - _e2789);
let _e2810 = -(_e2809);
let _e2813 = (_e2785 - select(_e2810, _e2809, (_e2809 > _e2810)));
let _e2815 = select(0f, _e2813, (_e2813 > 0f));
let _e2817 = select(_e2783, _e2815, (_e2815 < _e2783));
let _e2820 = (_e2813 - _e2783);
let _e2824 = (((_e2817 * (_e2817 * _e2786)) + select(0f, _e2820, (_e2820 > 0f))) * _e2787);
phi_4958_ = ((((select(_e2754, (1f - _e2754), (_e2739 >= 0f)) - select(_e2773, (1f - _e2773), (_e2758 >= 0f))) * (1f / _e2717)) * ((select(_e2805, (1f - _e2805), (_e2790 >= 0f)) - select(_e2824, (1f - _e2824), (_e2809 >= 0f))) * (1f / _e2727))) * bitcast<f32>((bitcast<u32>(_e2617) & 2147483647u)));
} else {
let _e2409 = (_e2397 >= _e2405);
let _e2410 = select(_e2315, _e2297, _e2409);
let _e2411 = select(_e2316, _e2298, _e2409);
let _e2412 = select(_e2317, _e2299, _e2409);
let _e2413 = select(_e2297, _e2315, _e2409);
let _e2414 = select(_e2298, _e2316, _e2409);
let _e2415 = select(_e2299, _e2317, _e2409);
let _e2420 = (((_e2410 * _e2410) + (_e2411 * _e2411)) + (_e2412 * _e2412));
let _e2423 = sqrt(select(0f, _e2420, (_e2420 > 0f)));
let _e2426 = (1f / select(1e-30f, _e2423, (_e2423 > 1e-30f)));
let _e2427 = (_e2410 * _e2426);
let _e2428 = (_e2411 * _e2426);
let _e2429 = (_e2412 * _e2426);
let _e2432 = ((_e1262.member_1.y * _e2429) - (_e1262.member_1.z * _e2428));
let _e2435 = ((_e1262.member_1.z * _e2427) - (_e1262.member_1.x * _e2429));
let _e2438 = ((_e1262.member_1.x * _e2428) - (_e1262.member_1.y * _e2427));
let _e2446 = bitcast<f32>((bitcast<u32>((((_e1335 * _e2427) + (_e1336 * _e2428)) + (_e1337 * _e2429))) & 2147483647u));
let _e2454 = bitcast<f32>((bitcast<u32>((((_e1347 * _e2427) + (_e1348 * _e2428)) + (_e1349 * _e2429))) & 2147483647u));
let _e2456 = select(_e2454, _e2446, (_e2446 > _e2454));
let _e2457 = (1e-3f * _e2423);
let _e2459 = select(_e2457, _e2456, (_e2456 > _e2457));
let _e2467 = bitcast<f32>((bitcast<u32>((((_e1335 * _e2432) + (_e1336 * _e2435)) + (_e1337 * _e2438))) & 2147483647u));
let _e2475 = bitcast<f32>((bitcast<u32>((((_e1347 * _e2432) + (_e1348 * _e2435)) + (_e1349 * _e2438))) & 2147483647u));
let _e2477 = select(_e2475, _e2467, (_e2467 > _e2475));
let _e2479 = select(_e2457, _e2477, (_e2477 > _e2457));
let _e2484 = (((_e2370 * _e2427) + (_e2371 * _e2428)) + (_e2372 * _e2429));
let _e2492 = bitcast<f32>((bitcast<u32>((((_e2413 * _e2427) + (_e2414 * _e2428)) + (_e2415 * _e2429))) & 2147483647u));
let _e2493 = (1e-4f * _e2459);
let _e2495 = select(_e2492, _e2423, (_e2423 > _e2492));
let _e2497 = select(_e2493, _e2495, (_e2495 > _e2493));
let _e2499 = select(_e2492, _e2423, (_e2423 < _e2492));
let _e2501 = select(_e2493, _e2499, (_e2499 > _e2493));
let _e2503 = (0.5f * (_e2497 + _e2501));
let _e2504 = (0.5f / _e2501);
let _e2505 = (1f / _e2497);
let _e2507 = (0.5f * _e2459);
let _e2508 = (_e2484 + _e2507);
let _e2509 = -(_e2508);
let _e2512 = (_e2503 - select(_e2509, _e2508, (_e2508 > _e2509)));
let _e2514 = select(0f, _e2512, (_e2512 > 0f));
let _e2516 = select(_e2501, _e2514, (_e2514 < _e2501));
let _e2519 = (_e2512 - _e2501);
let _e2523 = (((_e2516 * (_e2516 * _e2504)) + select(0f, _e2519, (_e2519 > 0f))) * _e2505);
let _e2527 = (_e2484 - _e2507);
let _e2528 = -(_e2527);
let _e2531 = (_e2503 - select(_e2528, _e2527, (_e2527 > _e2528)));
let _e2533 = select(0f, _e2531, (_e2531 > 0f));
let _e2535 = select(_e2501, _e2533, (_e2533 < _e2501));
let _e2538 = (_e2531 - _e2501);
let _e2542 = (((_e2535 * (_e2535 * _e2504)) + select(0f, _e2538, (_e2538 > 0f))) * _e2505);
let _e2552 = (((_e2370 * _e2432) + (_e2371 * _e2435)) + (_e2372 * _e2438));
let _e2560 = bitcast<f32>((bitcast<u32>((((_e2413 * _e2432) + (_e2414 * _e2435)) + (_e2415 * _e2438))) & 2147483647u));
let _e2561 = (1e-4f * _e2479);
let _e2563 = select(0f, _e2560, (_e2560 > 0f));
let _e2565 = select(_e2561, _e2563, (_e2563 > _e2561));
let _e2567 = select(0f, _e2560, (_e2560 < 0f));
let _e2569 = select(_e2561, _e2567, (_e2567 > _e2561));
let _e2571 = (0.5f * (_e2565 + _e2569));
let _e2572 = (0.5f / _e2569);
let _e2573 = (1f / _e2565);
let _e2575 = (0.5f * _e2479);
let _e2576 = (_e2552 + _e2575);
let _e2577 = -(_e2576);
let _e2580 = (_e2571 - select(_e2577, _e2576, (_e2576 > _e2577)));
let _e2582 = select(0f, _e2580, (_e2580 > 0f));
let _e2584 = select(_e2569, _e2582, (_e2582 < _e2569));
let _e2587 = (_e2580 - _e2569);
let _e2591 = (((_e2584 * (_e2584 * _e2572)) + select(0f, _e2587, (_e2587 > 0f))) * _e2573);
let _e2595 = (_e2552 - _e2575);
let _e2596 = -(_e2595);
let _e2599 = (_e2571 - select(_e2596, _e2595, (_e2595 > _e2596)));
let _e2601 = select(0f, _e2599, (_e2599 > 0f));
let _e2603 = select(_e2569, _e2601, (_e2601 < _e2569));
let _e2606 = (_e2599 - _e2569);
let _e2610 = (((_e2603 * (_e2603 * _e2572)) + select(0f, _e2606, (_e2606 > 0f))) * _e2573);
phi_4958_ = (((select(_e2523, (1f - _e2523), (_e2508 >= 0f)) - select(_e2542, (1f - _e2542), (_e2527 >= 0f))) * (1f / _e2459)) * ((select(_e2591, (1f - _e2591), (_e2576 >= 0f)) - select(_e2610, (1f - _e2610), (_e2595 >= 0f))) * (1f / _e2479)));
}
let _e2836 = phi_4958_;
let _e2837 = (_e2836 <= 0f);
if _e2837 {
phi_6027_ = vec3<f32>();
} else {
let _e2840 = (select(_e2249, _e2281, (_e2281 < _e2249)) - 0f);
let _e2844 = global_1.member.member_13.member_6;
if (_e2844 == 0u) {
phi_5694_ = _e2840;
} else {
let _e2847 = (_e2840 / f32(_e2844));
phi_4981_ = 0u;
phi_4984_ = 0f;
loop {
let _e2849 = phi_4981_;
let _e2851 = phi_4984_;
local_37 = _e2851;
let _e2854 = ((_e2849 < _e2844) && (_e2840 > 0f));
if _e2854 {
let _e2857 = (0f + (_e2847 * f32(_e2849)));
let _e2858 = (_e2857 + _e2847);
let _e2860 = (0.5f * (_e2857 + _e2858));
let _e2861 = (_e2858 - _e2857);
let _e2862 = (0.28867513f * _e2861);
let _e2863 = (_e2860 - _e2862);
let _e2873 = global_1.member.member_13.member_7;
let _e2874 = bitcast<i32>(_e2873);
let _e2878 = global_1.member.member_13.member_8;
let _e2879 = bitcast<i32>(_e2878);
let _e2883 = global_1.member.member_13.member_9;
let _e2884 = bitcast<i32>(_e2883);
let _e2888 = global_1.member.member_13.member_4;
let _e2895 = global_1.member.member_13.member_5;
let _e2899 = f32(_e2874);
let _e2901 = (_e2895.member - _e2888.member);
let _e2904 = (((((_e1977 + (_e2015 * _e2863)) - _e2888.member) / _e2901) * _e2899) - 0.5f);
let _e2905 = (_e2899 - 1f);
let _e2907 = select(0f, _e2904, (_e2904 > 0f));
let _e2909 = select(_e2905, _e2907, (_e2907 < _e2905));
let _e2910 = f32(_e2879);
let _e2912 = (_e2895.member_1 - _e2888.member_1);
let _e2915 = (((((_e1989 + (_e2028 * _e2863)) - _e2888.member_1) / _e2912) * _e2910) - 0.5f);
let _e2916 = (_e2910 - 1f);
let _e2918 = select(0f, _e2915, (_e2915 > 0f));
let _e2920 = select(_e2916, _e2918, (_e2918 < _e2916));
let _e2921 = f32(_e2884);
let _e2923 = (_e2895.member_2 - _e2888.member_2);
let _e2926 = (((((_e2002 + (_e2041 * _e2863)) - _e2888.member_2) / _e2923) * _e2921) - 0.5f);
let _e2927 = (_e2921 - 1f);
let _e2929 = select(0f, _e2926, (_e2926 > 0f));
let _e2931 = select(_e2927, _e2929, (_e2929 < _e2927));
let _e2933 = select(0f, _e2909, (_e2909 > 0f));
let _e2935 = select(1e6f, _e2933, (_e2933 < 1e6f));
let _e2942 = select(0i, select(select(i32(_e2935), i32(-2147483648), (_e2935 < -2147483600f)), 2147483647i, (_e2935 > 2147483500f)), (_e2935 == _e2935));
let _e2946 = (_e2942 - select(0i, 1i, (_e2935 < f32(_e2942))));
let _e2948 = select(0f, _e2920, (_e2920 > 0f));
let _e2950 = select(1e6f, _e2948, (_e2948 < 1e6f));
let _e2957 = select(0i, select(select(i32(_e2950), i32(-2147483648), (_e2950 < -2147483600f)), 2147483647i, (_e2950 > 2147483500f)), (_e2950 == _e2950));
let _e2961 = (_e2957 - select(0i, 1i, (_e2950 < f32(_e2957))));
let _e2963 = select(0f, _e2931, (_e2931 > 0f));
let _e2965 = select(1e6f, _e2963, (_e2963 < 1e6f));
let _e2972 = select(0i, select(select(i32(_e2965), i32(-2147483648), (_e2965 < -2147483600f)), 2147483647i, (_e2965 > 2147483500f)), (_e2965 == _e2965));
let _e2976 = (_e2972 - select(0i, 1i, (_e2965 < f32(_e2972))));
let _e2980 = (_e2920 - f32(_e2961));
let _e2982 = (_e2931 - f32(_e2976));
local_6 = (_e2909 - f32(_e2946));
let _e2983 = (_e2946 + 1i);
let _e2985 = select(_e2983, 0i, (_e2983 < 0i));
if (_e2985 >= _e2874) {
phi_5119_ = (_e2874 - 1i);
} else {
phi_5119_ = _e2985;
}
let _e2989 = phi_5119_;
local_7 = (_e2989 - _e2946);
let _e2991 = (_e2961 + 1i);
let _e2993 = select(_e2991, 0i, (_e2991 < 0i));
if (_e2993 >= _e2879) {
phi_5132_ = (_e2879 - 1i);
} else {
phi_5132_ = _e2993;
}
let _e2997 = phi_5132_;
let _e2999 = ((_e2997 - _e2961) * _e2874);
let _e3000 = (_e2976 + 1i);
let _e3002 = select(_e3000, 0i, (_e3000 < 0i));
if (_e3002 >= _e2884) {
phi_5146_ = (_e2884 - 1i);
} else {
phi_5146_ = _e3002;
}
let _e3006 = phi_5146_;
let _e3013 = global_1.member.member_13.member_10;
let _e3014 = bitcast<i32>(_e3013);
let _e3019 = ((_e3014 + (((_e2976 * _e2879) + _e2961) * _e2874)) + _e2946);
let _e3021 = select(_e1285, _e3019, (_e3019 < _e1285));
let _e3026 = global_8.member[bitcast<u32>(select(0i, _e3021, (_e3021 > 0i)))];
let _e3027 = local_6;
let _e3030 = local_7;
let _e3031 = (_e3019 + _e3030);
let _e3033 = select(_e1285, _e3031, (_e3031 < _e1285));
let _e3038 = global_8.member[bitcast<u32>(select(0i, _e3033, (_e3033 > 0i)))];
let _e3039 = local_6;
let _e3042 = (1f - _e2980);
let _e3044 = (_e3019 + _e2999);
let _e3046 = select(_e1285, _e3044, (_e3044 < _e1285));
let _e3051 = global_8.member[bitcast<u32>(select(0i, _e3046, (_e3046 > 0i)))];
let _e3052 = local_6;
let _e3055 = local_7;
let _e3056 = (_e3044 + _e3055);
let _e3058 = select(_e1285, _e3056, (_e3056 < _e1285));
let _e3063 = global_8.member[bitcast<u32>(select(0i, _e3058, (_e3058 > 0i)))];
let _e3064 = local_6;
let _e3069 = (_e3019 + (((_e3006 - _e2976) * _e2874) * _e2879));
let _e3071 = select(_e1285, _e3069, (_e3069 < _e1285));
let _e3076 = global_8.member[bitcast<u32>(select(0i, _e3071, (_e3071 > 0i)))];
let _e3077 = local_6;
let _e3080 = local_7;
let _e3081 = (_e3069 + _e3080);
let _e3083 = select(_e1285, _e3081, (_e3081 < _e1285));
let _e3088 = global_8.member[bitcast<u32>(select(0i, _e3083, (_e3083 > 0i)))];
let _e3089 = local_6;
let _e3093 = (_e3069 + _e2999);
let _e3095 = select(_e1285, _e3093, (_e3093 < _e1285));
let _e3100 = global_8.member[bitcast<u32>(select(0i, _e3095, (_e3095 > 0i)))];
let _e3101 = local_6;
let _e3104 = local_7;
let _e3105 = (_e3093 + _e3104);
let _e3107 = select(_e1285, _e3105, (_e3105 < _e1285));
let _e3112 = global_8.member[bitcast<u32>(select(0i, _e3107, (_e3107 > 0i)))];
let _e3113 = local_6;
let _e3122 = (_e2860 + _e2862);
let _e3132 = (((((_e1977 + (_e2015 * _e3122)) - _e2888.member) / _e2901) * _e2899) - 0.5f);
let _e3134 = select(0f, _e3132, (_e3132 > 0f));
let _e3136 = select(_e2905, _e3134, (_e3134 < _e2905));
let _e3140 = (((((_e1989 + (_e2028 * _e3122)) - _e2888.member_1) / _e2912) * _e2910) - 0.5f);
let _e3142 = select(0f, _e3140, (_e3140 > 0f));
let _e3144 = select(_e2916, _e3142, (_e3142 < _e2916));
let _e3148 = (((((_e2002 + (_e2041 * _e3122)) - _e2888.member_2) / _e2923) * _e2921) - 0.5f);
let _e3150 = select(0f, _e3148, (_e3148 > 0f));
let _e3152 = select(_e2927, _e3150, (_e3150 < _e2927));
let _e3154 = select(0f, _e3136, (_e3136 > 0f));
let _e3156 = select(1e6f, _e3154, (_e3154 < 1e6f));
let _e3163 = select(0i, select(select(i32(_e3156), i32(-2147483648), (_e3156 < -2147483600f)), 2147483647i, (_e3156 > 2147483500f)), (_e3156 == _e3156));
let _e3167 = (_e3163 - select(0i, 1i, (_e3156 < f32(_e3163))));
let _e3169 = select(0f, _e3144, (_e3144 > 0f));
let _e3171 = select(1e6f, _e3169, (_e3169 < 1e6f));
let _e3178 = select(0i, select(select(i32(_e3171), i32(-2147483648), (_e3171 < -2147483600f)), 2147483647i, (_e3171 > 2147483500f)), (_e3171 == _e3171));
let _e3182 = (_e3178 - select(0i, 1i, (_e3171 < f32(_e3178))));
let _e3184 = select(0f, _e3152, (_e3152 > 0f));
let _e3186 = select(1e6f, _e3184, (_e3184 < 1e6f));
let _e3193 = select(0i, select(select(i32(_e3186), i32(-2147483648), (_e3186 < -2147483600f)), 2147483647i, (_e3186 > 2147483500f)), (_e3186 == _e3186));
let _e3197 = (_e3193 - select(0i, 1i, (_e3186 < f32(_e3193))));
let _e3201 = (_e3144 - f32(_e3182));
let _e3203 = (_e3152 - f32(_e3197));
local_4 = (_e3136 - f32(_e3167));
let _e3204 = (_e3167 + 1i);
let _e3206 = select(_e3204, 0i, (_e3204 < 0i));
if (_e3206 >= _e2874) {
phi_5462_ = (_e2874 - 1i);
} else {
phi_5462_ = _e3206;
}
let _e3210 = phi_5462_;
local_5 = (_e3210 - _e3167);
let _e3212 = (_e3182 + 1i);
let _e3214 = select(_e3212, 0i, (_e3212 < 0i));
if (_e3214 >= _e2879) {
phi_5475_ = (_e2879 - 1i);
} else {
phi_5475_ = _e3214;
}
let _e3218 = phi_5475_;
let _e3220 = ((_e3218 - _e3182) * _e2874);
let _e3221 = (_e3197 + 1i);
let _e3223 = select(_e3221, 0i, (_e3221 < 0i));
if (_e3223 >= _e2884) {
phi_5489_ = (_e2884 - 1i);
} else {
phi_5489_ = _e3223;
}
let _e3227 = phi_5489_;
let _e3235 = ((_e3014 + (((_e3197 * _e2879) + _e3182) * _e2874)) + _e3167);
let _e3237 = select(_e1285, _e3235, (_e3235 < _e1285));
let _e3242 = global_8.member[bitcast<u32>(select(0i, _e3237, (_e3237 > 0i)))];
let _e3243 = local_4;
let _e3246 = local_5;
let _e3247 = (_e3235 + _e3246);
let _e3249 = select(_e1285, _e3247, (_e3247 < _e1285));
let _e3254 = global_8.member[bitcast<u32>(select(0i, _e3249, (_e3249 > 0i)))];
let _e3255 = local_4;
let _e3258 = (1f - _e3201);
let _e3260 = (_e3235 + _e3220);
let _e3262 = select(_e1285, _e3260, (_e3260 < _e1285));
let _e3267 = global_8.member[bitcast<u32>(select(0i, _e3262, (_e3262 > 0i)))];
let _e3268 = local_4;
let _e3271 = local_5;
let _e3272 = (_e3260 + _e3271);
let _e3274 = select(_e1285, _e3272, (_e3272 < _e1285));
let _e3279 = global_8.member[bitcast<u32>(select(0i, _e3274, (_e3274 > 0i)))];
let _e3280 = local_4;
let _e3285 = (_e3235 + (((_e3227 - _e3197) * _e2874) * _e2879));
let _e3287 = select(_e1285, _e3285, (_e3285 < _e1285));
let _e3292 = global_8.member[bitcast<u32>(select(0i, _e3287, (_e3287 > 0i)))];
let _e3293 = local_4;
let _e3296 = local_5;
let _e3297 = (_e3285 + _e3296);
let _e3299 = select(_e1285, _e3297, (_e3297 < _e1285));
let _e3304 = global_8.member[bitcast<u32>(select(0i, _e3299, (_e3299 > 0i)))];
let _e3305 = local_4;
let _e3309 = (_e3285 + _e3220);
let _e3311 = select(_e1285, _e3309, (_e3309 < _e1285));
let _e3316 = global_8.member[bitcast<u32>(select(0i, _e3311, (_e3311 > 0i)))];
let _e3317 = local_4;
let _e3320 = local_5;
let _e3321 = (_e3309 + _e3320);
let _e3323 = select(_e1285, _e3321, (_e3321 < _e1285));
let _e3328 = global_8.member[bitcast<u32>(select(0i, _e3323, (_e3323 > 0i)))];
let _e3329 = local_4;
phi_4982_ = (_e2849 + 1u);
phi_4985_ = (_e2851 + ((0.5f * (((((((_e3026 * (1f - _e3027)) + (_e3038 * _e3039)) * _e3042) + (((_e3051 * (1f - _e3052)) + (_e3063 * _e3064)) * _e2980)) * (1f - _e2982)) + (((((_e3076 * (1f - _e3077)) + (_e3088 * _e3089)) * _e3042) + (((_e3100 * (1f - _e3101)) + (_e3112 * _e3113)) * _e2980)) * _e2982)) + ((((((_e3242 * (1f - _e3243)) + (_e3254 * _e3255)) * _e3258) + (((_e3267 * (1f - _e3268)) + (_e3279 * _e3280)) * _e3201)) * (1f - _e3203)) + (((((_e3292 * (1f - _e3293)) + (_e3304 * _e3305)) * _e3258) + (((_e3316 * (1f - _e3317)) + (_e3328 * _e3329)) * _e3201)) * _e3203)))) * _e2861));
} else {
phi_4982_ = u32();
phi_4985_ = f32();
}
let _e3344 = phi_4982_;
let _e3346 = phi_4985_;
continue;
continuing {
phi_4981_ = _e3344;
phi_4984_ = _e3346;
break if !(_e2854);
}
}
let _e4504 = local_37;
phi_5694_ = _e4504;
}
let _e3349 = phi_5694_;
let _e3362 = (0.25f * bitcast<f32>((bitcast<u32>((((_e1262.member_2.x * _e2015) + (_e1262.member_2.y * _e2028)) + (_e1262.member_2.z * _e2041))) & 2147483647u)));
let _e3369 = (((_e1262.member_1.x * _e464) + (_e1262.member_1.y * _e475)) + (_e1262.member_1.z * _e486));
let _e3371 = select(1f, -1f, (_e3369 > 0f));
let _e3379 = select(_e3371, -(_e3371), ((((_e1262.member_2.x * _e1262.member_1.x) + (_e1262.member_2.y * _e1262.member_1.y)) + (_e1262.member_2.z * _e1262.member_1.z)) < 0f));
let _e3380 = (_e1262.member_2.x * _e3379);
let _e3381 = (_e1262.member_2.y * _e3379);
let _e3382 = (_e1262.member_2.z * _e3379);
let _e3391 = ((((_e3380 * _e464) + (_e3381 * _e475)) + (_e3382 * _e486)) > 0f);
let _e3400 = -((((select(_e3380, (_e1262.member_1.x * _e3371), _e3391) * _e2015) + (select(_e3381, (_e1262.member_1.y * _e3371), _e3391) * _e2028)) + (select(_e3382, (_e1262.member_1.z * _e3371), _e3391) * _e2041)));
let _e3405 = -(_e3400);
let _e3415 = global_1.member.member_13.member;
let _e3420 = -((_e3415.member * _e3349));
let _e3422 = select(-87f, _e3420, (_e3420 > -87f));
let _e3424 = select(88f, _e3422, (_e3422 < 88f));
let _e3426 = ((_e3424 * 1.442695f) + 0.5f);
let _e3428 = select(-127f, _e3426, (_e3426 > -127f));
let _e3430 = select(128f, _e3428, (_e3428 < 128f));
let _e3437 = select(0i, select(select(i32(_e3430), i32(-2147483648), (_e3430 < -2147483600f)), 2147483647i, (_e3430 > 2147483500f)), (_e3430 == _e3430));
let _e3441 = (_e3437 - select(0i, 1i, (_e3430 < f32(_e3437))));
let _e3442 = f32(_e3441);
let _e3446 = ((_e3424 - (_e3442 * 0.6933594f)) - (_e3442 * -2.1219444e-4f));
let _e3468 = -((_e3415.member_1 * _e3349));
let _e3470 = select(-87f, _e3468, (_e3468 > -87f));
let _e3472 = select(88f, _e3470, (_e3470 < 88f));
let _e3474 = ((_e3472 * 1.442695f) + 0.5f);
let _e3476 = select(-127f, _e3474, (_e3474 > -127f));
let _e3478 = select(128f, _e3476, (_e3476 < 128f));
let _e3485 = select(0i, select(select(i32(_e3478), i32(-2147483648), (_e3478 < -2147483600f)), 2147483647i, (_e3478 > 2147483500f)), (_e3478 == _e3478));
let _e3489 = (_e3485 - select(0i, 1i, (_e3478 < f32(_e3485))));
let _e3490 = f32(_e3489);
let _e3494 = ((_e3472 - (_e3490 * 0.6933594f)) - (_e3490 * -2.1219444e-4f));
let _e3516 = -((_e3415.member_2 * _e3349));
let _e3518 = select(-87f, _e3516, (_e3516 > -87f));
let _e3520 = select(88f, _e3518, (_e3518 < 88f));
let _e3522 = ((_e3520 * 1.442695f) + 0.5f);
let _e3524 = select(-127f, _e3522, (_e3522 > -127f));
let _e3526 = select(128f, _e3524, (_e3524 < 128f));
let _e3533 = select(0i, select(select(i32(_e3526), i32(-2147483648), (_e3526 < -2147483600f)), 2147483647i, (_e3526 > 2147483500f)), (_e3526 == _e3526));
let _e3537 = (_e3533 - select(0i, 1i, (_e3526 < f32(_e3533))));
let _e3538 = f32(_e3537);
let _e3542 = ((_e3520 - (_e3538 * 0.6933594f)) - (_e3538 * -2.1219444e-4f));
let _e3568 = ((_e2836 * (select((select(0f, _e3405, (_e3405 > 0f)) * _e1262.member_4), select(0f, _e3400, (_e3400 > 0f)), ((_e2267 * _e3369) > 0f)) / select(_e3362, _e2270, (_e2270 > _e3362)))) * (1f / 3.1415927f));
phi_6027_ = vec3<f32>(((_e2210 * ((1f + (_e3446 * (1f + (_e3446 * (0.5f + (_e3446 * (0.16666667f + (_e3446 * (0.041666668f + (_e3446 * (0.008333334f + (_e3446 * (0.001388889f + (_e3446 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3441 + 127i)) << bitcast<u32>(23i))))) * _e3568), ((_e2223 * ((1f + (_e3494 * (1f + (_e3494 * (0.5f + (_e3494 * (0.16666667f + (_e3494 * (0.041666668f + (_e3494 * (0.008333334f + (_e3494 * (0.001388889f + (_e3494 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3489 + 127i)) << bitcast<u32>(23i))))) * _e3568), ((_e2236 * ((1f + (_e3542 * (1f + (_e3542 * (0.5f + (_e3542 * (0.16666667f + (_e3542 * (0.041666668f + (_e3542 * (0.008333334f + (_e3542 * (0.001388889f + (_e3542 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3537 + 127i)) << bitcast<u32>(23i))))) * _e3568));
}
let _e3574 = phi_6027_;
phi_6028_ = _e3574;
phi_6029_ = _e2837;
}
let _e3576 = phi_6028_;
let _e3578 = phi_6029_;
phi_6033_ = _e3576;
phi_6034_ = _e3578;
}
let _e3580 = phi_6033_;
let _e3582 = phi_6034_;
phi_6050_ = (_e1899 + select(_e3580, vec3<f32>(0f, 0f, 0f), vec3(_e3582)));
}
let _e3587 = phi_6050_;
phi_3376_ = _e3587;
phi_3379_ = (_e1901 + 1u);
}
let _e3590 = phi_3376_;
let _e3592 = phi_3379_;
continue;
continuing {
phi_3375_ = _e3590;
phi_3378_ = _e3592;
break if !(select(true, false, _e1905));
}
}
let _e3595 = local_17.member_1;
phi_6060_ = type_17(_e1547.member, (_e1547.member_1 + 1u));
loop {
let _e3599 = phi_6060_;
local_39 = _e3599;
let _e3605 = (((_e3599.member_1 & 3u) == 0u) && (_e3599.member < _e3595));
if _e3605 {
phi_6061_ = type_17((_e3599.member + 1u), (_e3599.member_1 >> bitcast<u32>(2i)));
} else {
phi_6061_ = type_17();
}
let _e3611 = phi_6061_;
continue;
continuing {
phi_6060_ = _e3611;
break if !(_e3605);
}
}
let _e4517 = local_38;
phi_6082_ = _e4517;
let _e4520 = local_39;
phi_6083_ = _e4520;
}
let _e3618 = phi_6082_;
let _e3620 = phi_6083_;
phi_2783_ = _e3618;
phi_2786_ = _e3620;
} else {
phi_2783_ = vec3<f32>();
phi_2786_ = type_17();
}
let _e3622 = phi_2783_;
let _e3624 = phi_2786_;
continue;
continuing {
phi_2782_ = _e3622;
phi_2785_ = _e3624;
break if !(_e1555);
}
}
let _e4525 = local_40;
phi_2586_ = _e4525;
phi_2589_ = (_e1379 + 1u);
} else {
phi_2586_ = vec3<f32>();
phi_2589_ = u32();
}
let _e3628 = phi_2586_;
let _e3630 = phi_2589_;
continue;
continuing {
phi_2585_ = _e3628;
phi_2588_ = _e3630;
break if !(_e1384);
}
}
let _e3639 = (1f / select(_e464, select(1e-12f, -1e-12f, (_e464 < 0f)), (bitcast<f32>((bitcast<u32>(_e464) & 2147483647u)) < 1e-12f)));
let _e3647 = (1f / select(_e475, select(1e-12f, -1e-12f, (_e475 < 0f)), (bitcast<f32>((bitcast<u32>(_e475) & 2147483647u)) < 1e-12f)));
let _e3655 = (1f / select(_e486, select(1e-12f, -1e-12f, (_e486 < 0f)), (bitcast<f32>((bitcast<u32>(_e486) & 2147483647u)) < 1e-12f)));
let _e3659 = global_1.member.member_13.member_4;
let _e3666 = global_1.member.member_13.member_5;
let _e3671 = ((_e3659.member - _e781) * _e3639);
let _e3673 = ((_e3666.member - _e781) * _e3639);
let _e3675 = ((_e3659.member_1 - _e782) * _e3647);
let _e3677 = ((_e3666.member_1 - _e782) * _e3647);
let _e3679 = ((_e3659.member_2 - _e783) * _e3655);
let _e3681 = ((_e3666.member_2 - _e783) * _e3655);
let _e3683 = select(_e3673, _e3671, (_e3671 < _e3673));
let _e3685 = select(_e3677, _e3675, (_e3675 < _e3677));
let _e3687 = select(_e3685, _e3683, (_e3683 > _e3685));
let _e3689 = select(_e3681, _e3679, (_e3679 < _e3681));
let _e3691 = select(_e3689, _e3687, (_e3687 > _e3689));
let _e3693 = select(_e3673, _e3671, (_e3671 > _e3673));
let _e3695 = select(_e3677, _e3675, (_e3675 > _e3677));
let _e3697 = select(_e3695, _e3693, (_e3693 < _e3695));
let _e3699 = select(_e3681, _e3679, (_e3679 > _e3681));
let _e3701 = select(_e3699, _e3697, (_e3697 < _e3699));
let _e3703 = select(0f, _e3691, (_e3691 > 0f));
let _e3705 = select(_e784, _e3701, (_e3701 < _e784));
let _e3706 = (_e3705 > _e3703);
let _e3707 = select(0f, _e3703, _e3706);
let _e3709 = (select(0f, _e3705, _e3706) - _e3707);
let _e3713 = global_1.member.member_13.member_6;
if (_e3713 == 0u) {
phi_6945_ = _e3709;
} else {
let _e3716 = (_e3709 / f32(_e3713));
phi_6232_ = 0u;
phi_6235_ = 0f;
loop {
let _e3718 = phi_6232_;
let _e3720 = phi_6235_;
local_41 = _e3720;
let _e3723 = ((_e3718 < _e3713) && (_e3709 > 0f));
if _e3723 {
let _e3726 = (_e3707 + (_e3716 * f32(_e3718)));
let _e3727 = (_e3726 + _e3716);
let _e3729 = (0.5f * (_e3726 + _e3727));
let _e3730 = (_e3727 - _e3726);
let _e3731 = (0.28867513f * _e3730);
let _e3732 = (_e3729 - _e3731);
let _e3742 = global_1.member.member_13.member_7;
let _e3743 = bitcast<i32>(_e3742);
let _e3747 = global_1.member.member_13.member_8;
let _e3748 = bitcast<i32>(_e3747);
let _e3752 = global_1.member.member_13.member_9;
let _e3753 = bitcast<i32>(_e3752);
let _e3754 = f32(_e3743);
let _e3756 = (_e3666.member - _e3659.member);
let _e3759 = (((((_e781 + (_e464 * _e3732)) - _e3659.member) / _e3756) * _e3754) - 0.5f);
let _e3760 = (_e3754 - 1f);
let _e3762 = select(0f, _e3759, (_e3759 > 0f));
let _e3764 = select(_e3760, _e3762, (_e3762 < _e3760));
let _e3765 = f32(_e3748);
let _e3767 = (_e3666.member_1 - _e3659.member_1);
let _e3770 = (((((_e782 + (_e475 * _e3732)) - _e3659.member_1) / _e3767) * _e3765) - 0.5f);
let _e3771 = (_e3765 - 1f);
let _e3773 = select(0f, _e3770, (_e3770 > 0f));
let _e3775 = select(_e3771, _e3773, (_e3773 < _e3771));
let _e3776 = f32(_e3753);
let _e3778 = (_e3666.member_2 - _e3659.member_2);
let _e3781 = (((((_e783 + (_e486 * _e3732)) - _e3659.member_2) / _e3778) * _e3776) - 0.5f);
let _e3782 = (_e3776 - 1f);
let _e3784 = select(0f, _e3781, (_e3781 > 0f));
let _e3786 = select(_e3782, _e3784, (_e3784 < _e3782));
let _e3788 = select(0f, _e3764, (_e3764 > 0f));
let _e3790 = select(1e6f, _e3788, (_e3788 < 1e6f));
let _e3797 = select(0i, select(select(i32(_e3790), i32(-2147483648), (_e3790 < -2147483600f)), 2147483647i, (_e3790 > 2147483500f)), (_e3790 == _e3790));
let _e3801 = (_e3797 - select(0i, 1i, (_e3790 < f32(_e3797))));
let _e3803 = select(0f, _e3775, (_e3775 > 0f));
let _e3805 = select(1e6f, _e3803, (_e3803 < 1e6f));
let _e3812 = select(0i, select(select(i32(_e3805), i32(-2147483648), (_e3805 < -2147483600f)), 2147483647i, (_e3805 > 2147483500f)), (_e3805 == _e3805));
let _e3816 = (_e3812 - select(0i, 1i, (_e3805 < f32(_e3812))));
let _e3818 = select(0f, _e3786, (_e3786 > 0f));
let _e3820 = select(1e6f, _e3818, (_e3818 < 1e6f));
let _e3827 = select(0i, select(select(i32(_e3820), i32(-2147483648), (_e3820 < -2147483600f)), 2147483647i, (_e3820 > 2147483500f)), (_e3820 == _e3820));
let _e3831 = (_e3827 - select(0i, 1i, (_e3820 < f32(_e3827))));
let _e3835 = (_e3775 - f32(_e3816));
let _e3837 = (_e3786 - f32(_e3831));
local_2 = (_e3764 - f32(_e3801));
let _e3838 = (_e3801 + 1i);
let _e3840 = select(_e3838, 0i, (_e3838 < 0i));
if (_e3840 >= _e3743) {
phi_6370_ = (_e3743 - 1i);
} else {
phi_6370_ = _e3840;
}
let _e3844 = phi_6370_;
local_3 = (_e3844 - _e3801);
let _e3846 = (_e3816 + 1i);
let _e3848 = select(_e3846, 0i, (_e3846 < 0i));
if (_e3848 >= _e3748) {
phi_6383_ = (_e3748 - 1i);
} else {
phi_6383_ = _e3848;
}
let _e3852 = phi_6383_;
let _e3854 = ((_e3852 - _e3816) * _e3743);
let _e3855 = (_e3831 + 1i);
let _e3857 = select(_e3855, 0i, (_e3855 < 0i));
if (_e3857 >= _e3753) {
phi_6397_ = (_e3753 - 1i);
} else {
phi_6397_ = _e3857;
}
let _e3861 = phi_6397_;
let _e3868 = global_1.member.member_13.member_10;
let _e3869 = bitcast<i32>(_e3868);
let _e3874 = ((_e3869 + (((_e3831 * _e3748) + _e3816) * _e3743)) + _e3801);
let _e3876 = select(_e1285, _e3874, (_e3874 < _e1285));
let _e3881 = global_8.member[bitcast<u32>(select(0i, _e3876, (_e3876 > 0i)))];
let _e3882 = local_2;
let _e3885 = local_3;
let _e3886 = (_e3874 + _e3885);
let _e3888 = select(_e1285, _e3886, (_e3886 < _e1285));
let _e3893 = global_8.member[bitcast<u32>(select(0i, _e3888, (_e3888 > 0i)))];
let _e3894 = local_2;
let _e3897 = (1f - _e3835);
let _e3899 = (_e3874 + _e3854);
let _e3901 = select(_e1285, _e3899, (_e3899 < _e1285));
let _e3906 = global_8.member[bitcast<u32>(select(0i, _e3901, (_e3901 > 0i)))];
let _e3907 = local_2;
let _e3910 = local_3;
let _e3911 = (_e3899 + _e3910);
let _e3913 = select(_e1285, _e3911, (_e3911 < _e1285));
let _e3918 = global_8.member[bitcast<u32>(select(0i, _e3913, (_e3913 > 0i)))];
let _e3919 = local_2;
let _e3924 = (_e3874 + (((_e3861 - _e3831) * _e3743) * _e3748));
let _e3926 = select(_e1285, _e3924, (_e3924 < _e1285));
let _e3931 = global_8.member[bitcast<u32>(select(0i, _e3926, (_e3926 > 0i)))];
let _e3932 = local_2;
let _e3935 = local_3;
let _e3936 = (_e3924 + _e3935);
let _e3938 = select(_e1285, _e3936, (_e3936 < _e1285));
let _e3943 = global_8.member[bitcast<u32>(select(0i, _e3938, (_e3938 > 0i)))];
let _e3944 = local_2;
let _e3948 = (_e3924 + _e3854);
let _e3950 = select(_e1285, _e3948, (_e3948 < _e1285));
let _e3955 = global_8.member[bitcast<u32>(select(0i, _e3950, (_e3950 > 0i)))];
let _e3956 = local_2;
let _e3959 = local_3;
let _e3960 = (_e3948 + _e3959);
let _e3962 = select(_e1285, _e3960, (_e3960 < _e1285));
let _e3967 = global_8.member[bitcast<u32>(select(0i, _e3962, (_e3962 > 0i)))];
let _e3968 = local_2;
let _e3977 = (_e3729 + _e3731);
let _e3987 = (((((_e781 + (_e464 * _e3977)) - _e3659.member) / _e3756) * _e3754) - 0.5f);
let _e3989 = select(0f, _e3987, (_e3987 > 0f));
let _e3991 = select(_e3760, _e3989, (_e3989 < _e3760));
let _e3995 = (((((_e782 + (_e475 * _e3977)) - _e3659.member_1) / _e3767) * _e3765) - 0.5f);
let _e3997 = select(0f, _e3995, (_e3995 > 0f));
let _e3999 = select(_e3771, _e3997, (_e3997 < _e3771));
let _e4003 = (((((_e783 + (_e486 * _e3977)) - _e3659.member_2) / _e3778) * _e3776) - 0.5f);
let _e4005 = select(0f, _e4003, (_e4003 > 0f));
let _e4007 = select(_e3782, _e4005, (_e4005 < _e3782));
let _e4009 = select(0f, _e3991, (_e3991 > 0f));
let _e4011 = select(1e6f, _e4009, (_e4009 < 1e6f));
let _e4018 = select(0i, select(select(i32(_e4011), i32(-2147483648), (_e4011 < -2147483600f)), 2147483647i, (_e4011 > 2147483500f)), (_e4011 == _e4011));
let _e4022 = (_e4018 - select(0i, 1i, (_e4011 < f32(_e4018))));
let _e4024 = select(0f, _e3999, (_e3999 > 0f));
let _e4026 = select(1e6f, _e4024, (_e4024 < 1e6f));
let _e4033 = select(0i, select(select(i32(_e4026), i32(-2147483648), (_e4026 < -2147483600f)), 2147483647i, (_e4026 > 2147483500f)), (_e4026 == _e4026));
let _e4037 = (_e4033 - select(0i, 1i, (_e4026 < f32(_e4033))));
let _e4039 = select(0f, _e4007, (_e4007 > 0f));
let _e4041 = select(1e6f, _e4039, (_e4039 < 1e6f));
let _e4048 = select(0i, select(select(i32(_e4041), i32(-2147483648), (_e4041 < -2147483600f)), 2147483647i, (_e4041 > 2147483500f)), (_e4041 == _e4041));
let _e4052 = (_e4048 - select(0i, 1i, (_e4041 < f32(_e4048))));
let _e4056 = (_e3999 - f32(_e4037));
let _e4058 = (_e4007 - f32(_e4052));
local = (_e3991 - f32(_e4022));
let _e4059 = (_e4022 + 1i);
let _e4061 = select(_e4059, 0i, (_e4059 < 0i));
if (_e4061 >= _e3743) {
phi_6713_ = (_e3743 - 1i);
} else {
phi_6713_ = _e4061;
}
let _e4065 = phi_6713_;
local_1 = (_e4065 - _e4022);
let _e4067 = (_e4037 + 1i);
let _e4069 = select(_e4067, 0i, (_e4067 < 0i));
if (_e4069 >= _e3748) {
phi_6726_ = (_e3748 - 1i);
} else {
phi_6726_ = _e4069;
}
let _e4073 = phi_6726_;
let _e4075 = ((_e4073 - _e4037) * _e3743);
let _e4076 = (_e4052 + 1i);
let _e4078 = select(_e4076, 0i, (_e4076 < 0i));
if (_e4078 >= _e3753) {
phi_6740_ = (_e3753 - 1i);
} else {
phi_6740_ = _e4078;
}
let _e4082 = phi_6740_;
let _e4090 = ((_e3869 + (((_e4052 * _e3748) + _e4037) * _e3743)) + _e4022);
let _e4092 = select(_e1285, _e4090, (_e4090 < _e1285));
let _e4097 = global_8.member[bitcast<u32>(select(0i, _e4092, (_e4092 > 0i)))];
let _e4098 = local;
let _e4101 = local_1;
let _e4102 = (_e4090 + _e4101);
let _e4104 = select(_e1285, _e4102, (_e4102 < _e1285));
let _e4109 = global_8.member[bitcast<u32>(select(0i, _e4104, (_e4104 > 0i)))];
let _e4110 = local;
let _e4113 = (1f - _e4056);
let _e4115 = (_e4090 + _e4075);
let _e4117 = select(_e1285, _e4115, (_e4115 < _e1285));
let _e4122 = global_8.member[bitcast<u32>(select(0i, _e4117, (_e4117 > 0i)))];
let _e4123 = local;
let _e4126 = local_1;
let _e4127 = (_e4115 + _e4126);
let _e4129 = select(_e1285, _e4127, (_e4127 < _e1285));
let _e4134 = global_8.member[bitcast<u32>(select(0i, _e4129, (_e4129 > 0i)))];
let _e4135 = local;
let _e4140 = (_e4090 + (((_e4082 - _e4052) * _e3743) * _e3748));
let _e4142 = select(_e1285, _e4140, (_e4140 < _e1285));
let _e4147 = global_8.member[bitcast<u32>(select(0i, _e4142, (_e4142 > 0i)))];
let _e4148 = local;
let _e4151 = local_1;
let _e4152 = (_e4140 + _e4151);
let _e4154 = select(_e1285, _e4152, (_e4152 < _e1285));
let _e4159 = global_8.member[bitcast<u32>(select(0i, _e4154, (_e4154 > 0i)))];
let _e4160 = local;
let _e4164 = (_e4140 + _e4075);
let _e4166 = select(_e1285, _e4164, (_e4164 < _e1285));
let _e4171 = global_8.member[bitcast<u32>(select(0i, _e4166, (_e4166 > 0i)))];
let _e4172 = local;
let _e4175 = local_1;
let _e4176 = (_e4164 + _e4175);
let _e4178 = select(_e1285, _e4176, (_e4176 < _e1285));
let _e4183 = global_8.member[bitcast<u32>(select(0i, _e4178, (_e4178 > 0i)))];
let _e4184 = local;
phi_6233_ = (_e3718 + 1u);
phi_6236_ = (_e3720 + ((0.5f * (((((((_e3881 * (1f - _e3882)) + (_e3893 * _e3894)) * _e3897) + (((_e3906 * (1f - _e3907)) + (_e3918 * _e3919)) * _e3835)) * (1f - _e3837)) + (((((_e3931 * (1f - _e3932)) + (_e3943 * _e3944)) * _e3897) + (((_e3955 * (1f - _e3956)) + (_e3967 * _e3968)) * _e3835)) * _e3837)) + ((((((_e4097 * (1f - _e4098)) + (_e4109 * _e4110)) * _e4113) + (((_e4122 * (1f - _e4123)) + (_e4134 * _e4135)) * _e4056)) * (1f - _e4058)) + (((((_e4147 * (1f - _e4148)) + (_e4159 * _e4160)) * _e4113) + (((_e4171 * (1f - _e4172)) + (_e4183 * _e4184)) * _e4056)) * _e4058)))) * _e3730));
} else {
phi_6233_ = u32();
phi_6236_ = f32();
}
let _e4199 = phi_6233_;
let _e4201 = phi_6236_;
continue;
continuing {
phi_6232_ = _e4199;
phi_6235_ = _e4201;
break if !(_e3723);
}
}
let _e4539 = local_41;
phi_6945_ = _e4539;
}
let _e4204 = phi_6945_;
let _e4208 = global_1.member.member_13.member;
let _e4213 = -((_e4208.member * _e4204));
let _e4215 = select(-87f, _e4213, (_e4213 > -87f));
let _e4217 = select(88f, _e4215, (_e4215 < 88f));
let _e4219 = ((_e4217 * 1.442695f) + 0.5f);
let _e4221 = select(-127f, _e4219, (_e4219 > -127f));
let _e4223 = select(128f, _e4221, (_e4221 < 128f));
let _e4230 = select(0i, select(select(i32(_e4223), i32(-2147483648), (_e4223 < -2147483600f)), 2147483647i, (_e4223 > 2147483500f)), (_e4223 == _e4223));
let _e4234 = (_e4230 - select(0i, 1i, (_e4223 < f32(_e4230))));
let _e4235 = f32(_e4234);
let _e4239 = ((_e4217 - (_e4235 * 0.6933594f)) - (_e4235 * -2.1219444e-4f));
let _e4261 = -((_e4208.member_1 * _e4204));
let _e4263 = select(-87f, _e4261, (_e4261 > -87f));
let _e4265 = select(88f, _e4263, (_e4263 < 88f));
let _e4267 = ((_e4265 * 1.442695f) + 0.5f);
let _e4269 = select(-127f, _e4267, (_e4267 > -127f));
let _e4271 = select(128f, _e4269, (_e4269 < 128f));
let _e4278 = select(0i, select(select(i32(_e4271), i32(-2147483648), (_e4271 < -2147483600f)), 2147483647i, (_e4271 > 2147483500f)), (_e4271 == _e4271));
let _e4282 = (_e4278 - select(0i, 1i, (_e4271 < f32(_e4278))));
let _e4283 = f32(_e4282);
let _e4287 = ((_e4265 - (_e4283 * 0.6933594f)) - (_e4283 * -2.1219444e-4f));
let _e4309 = -((_e4208.member_2 * _e4204));
let _e4311 = select(-87f, _e4309, (_e4309 > -87f));
let _e4313 = select(88f, _e4311, (_e4311 < 88f));
let _e4315 = ((_e4313 * 1.442695f) + 0.5f);
let _e4317 = select(-127f, _e4315, (_e4315 > -127f));
let _e4319 = select(128f, _e4317, (_e4317 < 128f));
let _e4326 = select(0i, select(select(i32(_e4319), i32(-2147483648), (_e4319 < -2147483600f)), 2147483647i, (_e4319 > 2147483500f)), (_e4319 == _e4319));
let _e4330 = (_e4326 - select(0i, 1i, (_e4319 < f32(_e4326))));
let _e4331 = f32(_e4330);
let _e4335 = ((_e4313 - (_e4331 * 0.6933594f)) - (_e4331 * -2.1219444e-4f));
let _e4358 = local_33;
let _e4363 = local_34;
let _e4368 = local_35;
phi_7181_ = array<f32, 19>(_e171, _e181, _e192, (_e203 + (((_e4358.x * _e1262.member_3.x) * ((1f + (_e4239 * (1f + (_e4239 * (0.5f + (_e4239 * (0.16666667f + (_e4239 * (0.041666668f + (_e4239 * (0.008333334f + (_e4239 * (0.001388889f + (_e4239 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4234 + 127i)) << bitcast<u32>(23i))))) * select(_e629, 1f, _e699))), (_e214 + (((_e4363.y * _e1262.member_3.y) * ((1f + (_e4287 * (1f + (_e4287 * (0.5f + (_e4287 * (0.16666667f + (_e4287 * (0.041666668f + (_e4287 * (0.008333334f + (_e4287 * (0.001388889f + (_e4287 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4282 + 127i)) << bitcast<u32>(23i))))) * select(_e640, 1f, _e699))), (_e225 + (((_e4368.z * _e1262.member_3.z) * ((1f + (_e4335 * (1f + (_e4335 * (0.5f + (_e4335 * (0.16666667f + (_e4335 * (0.041666668f + (_e4335 * (0.008333334f + (_e4335 * (0.001388889f + (_e4335 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4330 + 127i)) << bitcast<u32>(23i))))) * select(_e651, 1f, _e699))), _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357, _e368);
} else {
phi_7181_ = array<f32, 19>(_e171, _e181, _e192, _e203, _e214, _e225, _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357, _e368);
}
let _e4383 = phi_7181_;
global_5.member[_e160] = _e4383[0];
global_5.member[_e172] = _e4383[1];
global_5.member[_e183] = _e4383[2];
global_5.member[_e194] = _e4383[3];
global_5.member[_e205] = _e4383[4];
global_5.member[_e216] = _e4383[5];
global_5.member[_e227] = _e4383[6];
global_5.member[_e238] = _e4383[7];
global_5.member[_e249] = _e4383[8];
global_5.member[_e260] = _e4383[9];
global_5.member[_e271] = _e4383[10];
global_5.member[_e282] = _e4383[11];
global_5.member[_e293] = _e4383[12];
global_5.member[_e304] = _e4383[13];
global_5.member[_e315] = _e4383[14];
global_5.member[_e326] = _e4383[15];
global_5.member[_e337] = _e4383[16];
global_5.member[_e348] = _e4383[17];
global_5.member[_e359] = _e4383[18];
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
