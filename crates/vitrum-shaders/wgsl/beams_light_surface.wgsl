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
var phi_2595_: u32;
var phi_2596_: u32;
var phi_2608_: u32;
var phi_2609_: u32;
var local_20: u32;
var local_21: u32;
var phi_2626_: u32;
var phi_2627_: u32;
var phi_2639_: u32;
var phi_2640_: u32;
var local_22: u32;
var local_23: u32;
var local_24: u32;
var phi_2665_: u32;
var phi_2666_: u32;
var local_25: u32;
var local_26: u32;
var phi_2683_: u32;
var phi_2684_: u32;
var local_27: u32;
var local_28: u32;
var phi_2706_: u32;
var phi_2707_: u32;
var phi_2719_: u32;
var phi_2720_: u32;
var local_29: u32;
var local_30: u32;
var local_31: u32;
var phi_2756_: u32;
var local_32: u32;
var phi_2769_: vec3<f32>;
var phi_2772_: type_17;
var phi_3031_: u32;
var phi_3048_: u32;
var phi_3051_: u32;
var phi_3070_: u32;
var phi_3049_: u32;
var phi_3052_: u32;
var phi_3360_: u32;
var phi_3362_: vec3<f32>;
var phi_3365_: u32;
var phi_3394_: u32;
var phi_3440_: i32;
var phi_5319_: f32;
var phi_5320_: f32;
var phi_5343_: u32;
var phi_5346_: f32;
var phi_5481_: i32;
var phi_5494_: i32;
var phi_5508_: i32;
var phi_5824_: i32;
var phi_5837_: i32;
var phi_5851_: i32;
var phi_5344_: u32;
var phi_5347_: f32;
var phi_6056_: f32;
var phi_6389_: vec3<f32>;
var phi_6390_: vec3<f32>;
var phi_6391_: bool;
var phi_6395_: vec3<f32>;
var phi_6396_: bool;
var phi_6412_: vec3<f32>;
var phi_3363_: vec3<f32>;
var phi_3366_: u32;
var phi_6422_: type_17;
var phi_6423_: type_17;
var phi_6444_: vec3<f32>;
var phi_6445_: type_17;
var phi_2770_: vec3<f32>;
var phi_2773_: type_17;
var phi_6593_: u32;
var phi_6596_: f32;
var phi_6731_: i32;
var phi_6744_: i32;
var phi_6758_: i32;
var phi_7074_: i32;
var phi_7087_: i32;
var phi_7101_: i32;
var phi_6594_: u32;
var phi_6597_: f32;
var phi_7306_: f32;
var local_33: vec3<f32>;
var local_34: vec3<f32>;
var local_35: vec3<f32>;
var phi_7542_: array<f32, 19>;
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
let _e1362 = (((_e1347 * _e1347) + (_e1348 * _e1348)) + (_e1349 * _e1349));
let _e1368 = (0.05f + (0.5f * (sqrt(select(0f, _e1354, (_e1354 > 0f))) + sqrt(select(0f, _e1362, (_e1362 > 0f))))));
let _e1372 = global_1.member.member_11.member;
let _e1378 = global_1.member.member_12.member_5;
let _e1382 = global_1.member.member_12.member_6;
phi_2595_ = 0u;
loop {
let _e1386 = phi_2595_;
local_32 = _e1386;
let _e1390 = ((1u << bitcast<u32>((_e1386 & 31u))) < _e1372);
if _e1390 {
phi_2596_ = (_e1386 + 1u);
} else {
phi_2596_ = u32();
}
let _e1393 = phi_2596_;
continue;
continuing {
phi_2595_ = _e1393;
break if !(_e1390);
}
}
phi_2608_ = 0u;
loop {
let _e1396 = phi_2608_;
local_20 = _e1396;
local_21 = _e1396;
let _e1400 = ((1u << bitcast<u32>((_e1396 & 31u))) < _e1372);
if _e1400 {
phi_2609_ = (_e1396 + 1u);
} else {
phi_2609_ = u32();
}
let _e1403 = phi_2609_;
continue;
continuing {
phi_2608_ = _e1403;
break if !(_e1400);
}
}
let _e1406 = local_20;
let _e1409 = local_21;
phi_2626_ = 0u;
loop {
let _e1412 = phi_2626_;
local_24 = _e1412;
let _e1416 = ((1u << bitcast<u32>((_e1412 & 31u))) < _e1372);
if _e1416 {
phi_2627_ = (_e1412 + 1u);
} else {
phi_2627_ = u32();
}
let _e1419 = phi_2627_;
continue;
continuing {
phi_2626_ = _e1419;
break if !(_e1416);
}
}
phi_2639_ = 0u;
loop {
let _e1422 = phi_2639_;
local_22 = _e1422;
local_23 = _e1422;
let _e1426 = ((1u << bitcast<u32>((_e1422 & 31u))) < _e1372);
if _e1426 {
phi_2640_ = (_e1422 + 1u);
} else {
phi_2640_ = u32();
}
let _e1429 = phi_2640_;
continue;
continuing {
phi_2639_ = _e1429;
break if !(_e1426);
}
}
let _e1432 = local_22;
let _e1435 = local_23;
let _e1438 = local_24;
let _e1447 = global_1.member.member_12.member_8;
phi_2665_ = 0u;
loop {
let _e1450 = phi_2665_;
local_25 = _e1450;
local_26 = _e1450;
let _e1454 = ((1u << bitcast<u32>((_e1450 & 31u))) < _e1372);
if _e1454 {
phi_2666_ = (_e1450 + 1u);
} else {
phi_2666_ = u32();
}
let _e1457 = phi_2666_;
continue;
continuing {
phi_2665_ = _e1457;
break if !(_e1454);
}
}
let _e1460 = local_25;
let _e1463 = local_26;
phi_2683_ = 0u;
loop {
let _e1466 = phi_2683_;
local_27 = _e1466;
local_28 = _e1466;
let _e1470 = ((1u << bitcast<u32>((_e1466 & 31u))) < _e1372);
if _e1470 {
phi_2684_ = (_e1466 + 1u);
} else {
phi_2684_ = u32();
}
let _e1473 = phi_2684_;
continue;
continuing {
phi_2683_ = _e1473;
break if !(_e1470);
}
}
let _e1476 = local_27;
let _e1482 = local_28;
phi_2706_ = 0u;
loop {
let _e1492 = phi_2706_;
local_31 = _e1492;
let _e1496 = ((1u << bitcast<u32>((_e1492 & 31u))) < _e1372);
if _e1496 {
phi_2707_ = (_e1492 + 1u);
} else {
phi_2707_ = u32();
}
let _e1499 = phi_2707_;
continue;
continuing {
phi_2706_ = _e1499;
break if !(_e1496);
}
}
phi_2719_ = 0u;
loop {
let _e1502 = phi_2719_;
local_29 = _e1502;
local_30 = _e1502;
let _e1506 = ((1u << bitcast<u32>((_e1502 & 31u))) < _e1372);
if _e1506 {
phi_2720_ = (_e1502 + 1u);
} else {
phi_2720_ = u32();
}
let _e1509 = phi_2720_;
continue;
continuing {
phi_2719_ = _e1509;
break if !(_e1506);
}
}
let _e1512 = local_29;
let _e1515 = local_30;
let _e1518 = local_31;
let _e1524 = (((((1u << bitcast<u32>(((2u * _e1476) & 31u))) - (1u << bitcast<u32>(((2u * (_e1482 - select(6u, _e1463, (_e1460 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1518 - select(6u, _e1515, (_e1512 < 6u)))) & 31u))));
let _e1525 = (_e1524 / 64u);
if ((_e1524 % 64u) > 0u) {
phi_2756_ = (_e1525 + 1u);
} else {
phi_2756_ = _e1525;
}
let _e1530 = phi_2756_;
let _e1533 = local_32;
local_17 = type_24(_e1533, select(6u, _e1409, (_e1406 < 6u)), (1u << bitcast<u32>(((2u * (_e1438 - select(6u, _e1435, (_e1432 < 6u)))) & 31u))), (_e1378 * _e1447), (_e1530 * 64u));
let _e1536 = local_17.member_1;
phi_2769_ = vec3<f32>(0f, 0f, 0f);
phi_2772_ = type_17(_e1536, 0u);
loop {
let _e1539 = phi_2769_;
let _e1541 = phi_2772_;
local_33 = _e1539;
local_34 = _e1539;
local_35 = _e1539;
let _e1544 = local_17.member_1;
let _e1547 = local_17.member_2;
let _e1549 = ((_e1541.member < _e1544) || (_e1541.member_1 < _e1547));
if _e1549 {
local_15.member = _e1541.member;
local_15.member_1 = _e1541.member_1;
let _e1553 = local_15.member;
let _e1554 = local_15.member_1;
let _e1556 = local_17.member;
let _e1571 = local_17.member_3;
let _e1573 = local_17.member_4;
local_16 = ((_e1571 + (18u * _e1573)) + (((((1u << bitcast<u32>(((2u * _e1556) & 31u))) - (1u << bitcast<u32>(((2u * (_e1556 - _e1553)) & 31u)))) / 3u) * 4u) + _e1554));
let _e1577 = local_16;
let _e1578 = bitcast<i32>(_e1577);
let _e1580 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1582 = select(_e1580, _e1578, (_e1578 < _e1580));
let _e1587 = global_4.member[bitcast<u32>(select(0i, _e1582, (_e1582 > 0i)))];
let _e1588 = local_16;
let _e1589 = local_17.member_4;
let _e1591 = bitcast<i32>((_e1588 + _e1589));
let _e1593 = select(_e1580, _e1591, (_e1591 < _e1580));
let _e1598 = global_4.member[bitcast<u32>(select(0i, _e1593, (_e1593 > 0i)))];
let _e1599 = local_16;
let _e1600 = local_17.member_4;
let _e1603 = bitcast<i32>((_e1599 + (2u * _e1600)));
let _e1605 = select(_e1580, _e1603, (_e1603 < _e1580));
let _e1610 = global_4.member[bitcast<u32>(select(0i, _e1605, (_e1605 > 0i)))];
let _e1611 = local_15.member;
let _e1612 = local_15.member_1;
let _e1613 = local_17.member;
let _e1627 = local_17.member_3;
let _e1628 = local_17.member_4;
local_14 = ((_e1627 + (21u * _e1628)) + (((((1u << bitcast<u32>(((2u * _e1613) & 31u))) - (1u << bitcast<u32>(((2u * (_e1613 - _e1611)) & 31u)))) / 3u) * 4u) + _e1612));
let _e1632 = local_14;
let _e1633 = bitcast<i32>(_e1632);
let _e1635 = select(_e1580, _e1633, (_e1633 < _e1580));
let _e1640 = global_4.member[bitcast<u32>(select(0i, _e1635, (_e1635 > 0i)))];
let _e1641 = local_14;
let _e1642 = local_17.member_4;
let _e1644 = bitcast<i32>((_e1641 + _e1642));
let _e1646 = select(_e1580, _e1644, (_e1644 < _e1580));
let _e1651 = global_4.member[bitcast<u32>(select(0i, _e1646, (_e1646 > 0i)))];
let _e1652 = local_14;
let _e1653 = local_17.member_4;
let _e1656 = bitcast<i32>((_e1652 + (2u * _e1653)));
let _e1658 = select(_e1580, _e1656, (_e1656 < _e1580));
let _e1663 = global_4.member[bitcast<u32>(select(0i, _e1658, (_e1658 > 0i)))];
let _e1685 = ((((_e1587 <= _e1640) && ((_e1262.member.x >= (_e1587 - _e1368)) && (_e1262.member.x <= (_e1640 + _e1368)))) && ((_e1262.member.y >= (_e1598 - _e1368)) && (_e1262.member.y <= (_e1651 + _e1368)))) && ((_e1262.member.z >= (_e1610 - _e1368)) && (_e1262.member.z <= (_e1663 + _e1368))));
let _e1686 = local_17.member_1;
if (_e1686 < 2u) {
let _e1688 = local_17.member_1;
phi_3031_ = _e1688;
} else {
phi_3031_ = 2u;
}
let _e1690 = phi_3031_;
if (_e1685 && (_e1541.member > _e1690)) {
phi_6444_ = _e1539;
phi_6445_ = type_17((_e1541.member - 1u), (_e1541.member_1 << bitcast<u32>(2i)));
} else {
if _e1685 {
phi_3048_ = 0u;
phi_3051_ = 0u;
loop {
let _e1694 = phi_3048_;
let _e1696 = phi_3051_;
local_36 = _e1696;
let _e1697 = (_e1694 < 16u);
if _e1697 {
let _e1698 = local_17.member_1;
if (_e1698 < 2u) {
let _e1700 = local_17.member_1;
phi_3070_ = _e1700;
} else {
phi_3070_ = 2u;
}
let _e1702 = phi_3070_;
let _e1704 = ((2u * _e1702) & 31u);
let _e1707 = ((_e1541.member_1 << bitcast<u32>(_e1704)) + _e1694);
let _e1708 = (_e1707 & 1431655765u);
let _e1712 = ((_e1708 | (_e1708 >> bitcast<u32>(1i))) & 858993459u);
let _e1716 = ((_e1712 | (_e1712 >> bitcast<u32>(2i))) & 252645135u);
let _e1720 = ((_e1716 | (_e1716 >> bitcast<u32>(4i))) & 16711935u);
let _e1727 = ((_e1707 >> bitcast<u32>(1i)) & 1431655765u);
let _e1731 = ((_e1727 | (_e1727 >> bitcast<u32>(1i))) & 858993459u);
let _e1735 = ((_e1731 | (_e1731 >> bitcast<u32>(2i))) & 252645135u);
let _e1739 = ((_e1735 | (_e1735 >> bitcast<u32>(4i))) & 16711935u);
local_12.member = 0u;
local_12.member_1 = _e1707;
let _e1753 = local_12.member;
let _e1754 = local_12.member_1;
let _e1755 = local_17.member;
let _e1769 = local_17.member_3;
let _e1770 = local_17.member_4;
local_13 = ((_e1769 + (18u * _e1770)) + (((((1u << bitcast<u32>(((2u * _e1755) & 31u))) - (1u << bitcast<u32>(((2u * (_e1755 - _e1753)) & 31u)))) / 3u) * 4u) + _e1754));
let _e1774 = local_13;
let _e1775 = bitcast<i32>(_e1774);
let _e1777 = select(_e1580, _e1775, (_e1775 < _e1580));
let _e1782 = global_4.member[bitcast<u32>(select(0i, _e1777, (_e1777 > 0i)))];
let _e1783 = local_13;
let _e1784 = local_17.member_4;
let _e1786 = bitcast<i32>((_e1783 + _e1784));
let _e1788 = select(_e1580, _e1786, (_e1786 < _e1580));
let _e1793 = global_4.member[bitcast<u32>(select(0i, _e1788, (_e1788 > 0i)))];
let _e1794 = local_13;
let _e1795 = local_17.member_4;
let _e1798 = bitcast<i32>((_e1794 + (2u * _e1795)));
let _e1800 = select(_e1580, _e1798, (_e1798 < _e1580));
let _e1805 = global_4.member[bitcast<u32>(select(0i, _e1800, (_e1800 > 0i)))];
let _e1806 = local_12.member;
let _e1807 = local_12.member_1;
let _e1808 = local_17.member;
let _e1822 = local_17.member_3;
let _e1823 = local_17.member_4;
local_11 = ((_e1822 + (21u * _e1823)) + (((((1u << bitcast<u32>(((2u * _e1808) & 31u))) - (1u << bitcast<u32>(((2u * (_e1808 - _e1806)) & 31u)))) / 3u) * 4u) + _e1807));
let _e1827 = local_11;
let _e1828 = bitcast<i32>(_e1827);
let _e1830 = select(_e1580, _e1828, (_e1828 < _e1580));
let _e1835 = global_4.member[bitcast<u32>(select(0i, _e1830, (_e1830 > 0i)))];
let _e1836 = local_11;
let _e1837 = local_17.member_4;
let _e1839 = bitcast<i32>((_e1836 + _e1837));
let _e1841 = select(_e1580, _e1839, (_e1839 < _e1580));
let _e1846 = global_4.member[bitcast<u32>(select(0i, _e1841, (_e1841 > 0i)))];
let _e1847 = local_11;
let _e1848 = local_17.member_4;
let _e1851 = bitcast<i32>((_e1847 + (2u * _e1848)));
let _e1853 = select(_e1580, _e1851, (_e1851 < _e1580));
let _e1858 = global_4.member[bitcast<u32>(select(0i, _e1853, (_e1853 > 0i)))];
phi_3049_ = (_e1694 + 1u);
phi_3052_ = (_e1696 | (select(0u, 1u, ((((_e1694 < (1u << bitcast<u32>(_e1704))) && (((_e1720 | (_e1720 >> bitcast<u32>(8i))) & 65535u) < _e1372)) && (((_e1739 | (_e1739 >> bitcast<u32>(8i))) & 65535u) < _e1372)) && ((((_e1782 <= _e1835) && ((_e1262.member.x >= (_e1782 - _e1368)) && (_e1262.member.x <= (_e1835 + _e1368)))) && ((_e1262.member.y >= (_e1793 - _e1368)) && (_e1262.member.y <= (_e1846 + _e1368)))) && ((_e1262.member.z >= (_e1805 - _e1368)) && (_e1262.member.z <= (_e1858 + _e1368)))))) << bitcast<u32>((_e1694 & 31u))));
} else {
phi_3049_ = u32();
phi_3052_ = u32();
}
let _e1886 = phi_3049_;
let _e1888 = phi_3052_;
continue;
continuing {
phi_3048_ = _e1886;
phi_3051_ = _e1888;
break if !(_e1697);
}
}
let _e4680 = local_36;
phi_3360_ = _e4680;
} else {
phi_3360_ = 0u;
}
let _e1891 = phi_3360_;
phi_3362_ = _e1539;
phi_3365_ = 0u;
loop {
let _e1893 = phi_3362_;
let _e1895 = phi_3365_;
local_38 = _e1893;
let _e1898 = (_e1891 >> bitcast<u32>((_e1895 & 31u)));
let _e1899 = (_e1898 == 0u);
if _e1899 {
phi_3363_ = vec3<f32>();
phi_3366_ = u32();
} else {
if ((_e1898 & 1u) == 0u) {
phi_6412_ = _e1893;
} else {
let _e1902 = local_17.member_1;
if (_e1902 < 2u) {
let _e1904 = local_17.member_1;
phi_3394_ = _e1904;
} else {
phi_3394_ = 2u;
}
let _e1906 = phi_3394_;
let _e1908 = ((2u * _e1906) & 31u);
let _e1911 = ((_e1541.member_1 << bitcast<u32>(_e1908)) + _e1895);
let _e1912 = (_e1911 & 1431655765u);
let _e1916 = ((_e1912 | (_e1912 >> bitcast<u32>(1i))) & 858993459u);
let _e1920 = ((_e1916 | (_e1916 >> bitcast<u32>(2i))) & 252645135u);
let _e1924 = ((_e1920 | (_e1920 >> bitcast<u32>(4i))) & 16711935u);
let _e1928 = ((_e1924 | (_e1924 >> bitcast<u32>(8i))) & 65535u);
let _e1931 = ((_e1911 >> bitcast<u32>(1i)) & 1431655765u);
let _e1935 = ((_e1931 | (_e1931 >> bitcast<u32>(1i))) & 858993459u);
let _e1939 = ((_e1935 | (_e1935 >> bitcast<u32>(2i))) & 252645135u);
let _e1943 = ((_e1939 | (_e1939 >> bitcast<u32>(4i))) & 16711935u);
let _e1947 = ((_e1943 | (_e1943 >> bitcast<u32>(8i))) & 65535u);
if (((_e1895 < (1u << bitcast<u32>(_e1908))) && (_e1928 < _e1372)) && (_e1947 < _e1372)) {
phi_3440_ = bitcast<i32>(((_e1947 * _e1372) + _e1928));
} else {
phi_3440_ = 0i;
}
let _e1959 = phi_3440_;
local_8 = bitcast<i32>((_e1378 * _e1382));
local_9 = _e1959;
local_10 = bitcast<i32>((_e1372 * _e1372));
let _e1960 = local_8;
let _e1961 = local_9;
let _e1962 = (_e1960 + _e1961);
let _e1964 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e1966 = select(_e1964, _e1962, (_e1962 < _e1964));
let _e1971 = global_3.member[bitcast<u32>(select(0i, _e1966, (_e1966 > 0i)))];
let _e1972 = local_8;
let _e1973 = local_10;
let _e1975 = local_9;
let _e1976 = ((_e1972 + _e1973) + _e1975);
let _e1978 = select(_e1964, _e1976, (_e1976 < _e1964));
let _e1983 = global_3.member[bitcast<u32>(select(0i, _e1978, (_e1978 > 0i)))];
let _e1984 = local_8;
let _e1985 = local_10;
let _e1988 = local_9;
let _e1989 = ((_e1984 + (2i * _e1985)) + _e1988);
let _e1991 = select(_e1964, _e1989, (_e1989 < _e1964));
let _e1996 = global_3.member[bitcast<u32>(select(0i, _e1991, (_e1991 > 0i)))];
let _e1997 = local_8;
let _e1998 = local_10;
let _e2001 = local_9;
let _e2002 = ((_e1997 + (3i * _e1998)) + _e2001);
let _e2004 = select(_e1964, _e2002, (_e2002 < _e1964));
let _e2009 = global_3.member[bitcast<u32>(select(0i, _e2004, (_e2004 > 0i)))];
let _e2010 = local_8;
let _e2011 = local_10;
let _e2014 = local_9;
let _e2015 = ((_e2010 + (4i * _e2011)) + _e2014);
let _e2017 = select(_e1964, _e2015, (_e2015 < _e1964));
let _e2022 = global_3.member[bitcast<u32>(select(0i, _e2017, (_e2017 > 0i)))];
let _e2023 = local_8;
let _e2024 = local_10;
let _e2027 = local_9;
let _e2028 = ((_e2023 + (5i * _e2024)) + _e2027);
let _e2030 = select(_e1964, _e2028, (_e2028 < _e1964));
let _e2035 = global_3.member[bitcast<u32>(select(0i, _e2030, (_e2030 > 0i)))];
let _e2036 = local_8;
let _e2037 = local_10;
let _e2040 = local_9;
let _e2041 = ((_e2036 + (6i * _e2037)) + _e2040);
let _e2043 = select(_e1964, _e2041, (_e2041 < _e1964));
let _e2048 = global_3.member[bitcast<u32>(select(0i, _e2043, (_e2043 > 0i)))];
let _e2049 = local_8;
let _e2050 = local_10;
let _e2053 = local_9;
let _e2054 = ((_e2049 + (7i * _e2050)) + _e2053);
let _e2056 = select(_e1964, _e2054, (_e2054 < _e1964));
let _e2061 = global_3.member[bitcast<u32>(select(0i, _e2056, (_e2056 > 0i)))];
let _e2062 = local_8;
let _e2063 = local_10;
let _e2066 = local_9;
let _e2067 = ((_e2062 + (8i * _e2063)) + _e2066);
let _e2069 = select(_e1964, _e2067, (_e2067 < _e1964));
let _e2074 = global_3.member[bitcast<u32>(select(0i, _e2069, (_e2069 > 0i)))];
let _e2075 = local_8;
let _e2076 = local_10;
let _e2079 = local_9;
let _e2080 = ((_e2075 + (9i * _e2076)) + _e2079);
let _e2082 = select(_e1964, _e2080, (_e2080 < _e1964));
let _e2087 = global_3.member[bitcast<u32>(select(0i, _e2082, (_e2082 > 0i)))];
let _e2088 = local_8;
let _e2089 = local_10;
let _e2092 = local_9;
let _e2093 = ((_e2088 + (10i * _e2089)) + _e2092);
let _e2095 = select(_e1964, _e2093, (_e2093 < _e1964));
let _e2100 = global_3.member[bitcast<u32>(select(0i, _e2095, (_e2095 > 0i)))];
let _e2101 = local_8;
let _e2102 = local_10;
let _e2105 = local_9;
let _e2106 = ((_e2101 + (11i * _e2102)) + _e2105);
let _e2108 = select(_e1964, _e2106, (_e2106 < _e1964));
let _e2113 = global_3.member[bitcast<u32>(select(0i, _e2108, (_e2108 > 0i)))];
let _e2114 = local_8;
let _e2115 = local_10;
let _e2118 = local_9;
let _e2119 = ((_e2114 + (12i * _e2115)) + _e2118);
let _e2121 = select(_e1964, _e2119, (_e2119 < _e1964));
let _e2126 = global_3.member[bitcast<u32>(select(0i, _e2121, (_e2121 > 0i)))];
let _e2127 = local_8;
let _e2128 = local_10;
let _e2131 = local_9;
let _e2132 = ((_e2127 + (13i * _e2128)) + _e2131);
let _e2134 = select(_e1964, _e2132, (_e2132 < _e1964));
let _e2139 = global_3.member[bitcast<u32>(select(0i, _e2134, (_e2134 > 0i)))];
let _e2140 = local_8;
let _e2141 = local_10;
let _e2144 = local_9;
let _e2145 = ((_e2140 + (14i * _e2141)) + _e2144);
let _e2147 = select(_e1964, _e2145, (_e2145 < _e1964));
let _e2152 = global_3.member[bitcast<u32>(select(0i, _e2147, (_e2147 > 0i)))];
let _e2153 = local_8;
let _e2154 = local_10;
let _e2157 = local_9;
let _e2158 = ((_e2153 + (15i * _e2154)) + _e2157);
let _e2160 = select(_e1964, _e2158, (_e2158 < _e1964));
let _e2165 = global_3.member[bitcast<u32>(select(0i, _e2160, (_e2160 > 0i)))];
let _e2166 = local_8;
let _e2167 = local_10;
let _e2170 = local_9;
let _e2171 = ((_e2166 + (16i * _e2167)) + _e2170);
let _e2173 = select(_e1964, _e2171, (_e2171 < _e1964));
let _e2178 = global_3.member[bitcast<u32>(select(0i, _e2173, (_e2173 > 0i)))];
let _e2179 = local_8;
let _e2180 = local_10;
let _e2183 = local_9;
let _e2184 = ((_e2179 + (17i * _e2180)) + _e2183);
let _e2186 = select(_e1964, _e2184, (_e2184 < _e1964));
let _e2191 = global_3.member[bitcast<u32>(select(0i, _e2186, (_e2186 > 0i)))];
let _e2192 = local_8;
let _e2193 = local_10;
let _e2196 = local_9;
let _e2197 = ((_e2192 + (18i * _e2193)) + _e2196);
let _e2199 = select(_e1964, _e2197, (_e2197 < _e1964));
let _e2204 = global_3.member[bitcast<u32>(select(0i, _e2199, (_e2199 > 0i)))];
let _e2205 = local_8;
let _e2206 = local_10;
let _e2209 = local_9;
let _e2210 = ((_e2205 + (19i * _e2206)) + _e2209);
let _e2212 = select(_e1964, _e2210, (_e2210 < _e1964));
let _e2217 = global_3.member[bitcast<u32>(select(0i, _e2212, (_e2212 > 0i)))];
let _e2218 = local_8;
let _e2219 = local_10;
let _e2222 = local_9;
let _e2223 = ((_e2218 + (20i * _e2219)) + _e2222);
let _e2225 = select(_e1964, _e2223, (_e2223 < _e1964));
let _e2230 = global_3.member[bitcast<u32>(select(0i, _e2225, (_e2225 > 0i)))];
let _e2231 = local_8;
let _e2232 = local_10;
let _e2235 = local_9;
let _e2236 = ((_e2231 + (23i * _e2232)) + _e2235);
let _e2238 = select(_e1964, _e2236, (_e2236 < _e1964));
let _e2243 = global_3.member[bitcast<u32>(select(0i, _e2238, (_e2238 > 0i)))];
let _e2244 = local_8;
let _e2245 = local_10;
let _e2248 = local_9;
let _e2249 = ((_e2244 + (24i * _e2245)) + _e2248);
let _e2251 = select(_e1964, _e2249, (_e2249 < _e1964));
let _e2256 = global_3.member[bitcast<u32>(select(0i, _e2251, (_e2251 > 0i)))];
let _e2261 = (((_e1262.member_1.x * _e2009) + (_e1262.member_1.y * _e2022)) + (_e1262.member_1.z * _e2035));
let _e2264 = bitcast<f32>((bitcast<u32>(_e2261) & 2147483647u));
if (_e2264 < 1e-6f) {
phi_6395_ = vec3<f32>();
phi_6396_ = true;
} else {
let _e2266 = (1f / _e2261);
let _e2275 = ((((_e1262.member_1.x * (_e1262.member.x - _e1971)) + (_e1262.member_1.y * (_e1262.member.y - _e1983))) + (_e1262.member_1.z * (_e1262.member.z - _e1996))) * _e2266);
let _e2279 = (_e2048 + (_e2126 * _e2275));
let _e2280 = (_e2061 + (_e2139 * _e2275));
let _e2281 = (_e2074 + (_e2152 * _e2275));
let _e2287 = ((((_e1262.member_1.x * _e2279) + (_e1262.member_1.y * _e2280)) + (_e1262.member_1.z * _e2281)) * _e2266);
let _e2291 = (_e2279 - (_e2009 * _e2287));
let _e2292 = (_e2280 - (_e2022 * _e2287));
let _e2293 = (_e2281 - (_e2035 * _e2287));
let _e2297 = (_e2087 + (_e2165 * _e2275));
let _e2298 = (_e2100 + (_e2178 * _e2275));
let _e2299 = (_e2113 + (_e2191 * _e2275));
let _e2305 = ((((_e1262.member_1.x * _e2297) + (_e1262.member_1.y * _e2298)) + (_e1262.member_1.z * _e2299)) * _e2266);
let _e2309 = (_e2297 - (_e2009 * _e2305));
let _e2310 = (_e2298 - (_e2022 * _e2305));
let _e2311 = (_e2299 - (_e2035 * _e2305));
let _e2347 = (((0.5f * (bitcast<f32>((bitcast<u32>((((_e2291 * _e2009) + (_e2292 * _e2022)) + (_e2293 * _e2035))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((((_e2309 * _e2009) + (_e2310 * _e2022)) + (_e2311 * _e2035))) & 2147483647u)))) + bitcast<f32>((bitcast<u32>((((_e1335 * _e2009) + (_e1336 * _e2022)) + (_e1337 * _e2035))) & 2147483647u))) + bitcast<f32>((bitcast<u32>((((_e1347 * _e2009) + (_e1348 * _e2022)) + (_e1349 * _e2035))) & 2147483647u)));
if ((_e2275 < (-(0.05f) - _e2347)) || (bitcast<f32>((bitcast<u32>((_e2275 - _e2256)) & 2147483647u)) > (_e2347 + 0.05f))) {
phi_6390_ = vec3<f32>();
phi_6391_ = true;
} else {
let _e2364 = (_e1262.member.x - (_e1971 + (_e2009 * _e2275)));
let _e2365 = (_e1262.member.y - (_e1983 + (_e2022 * _e2275)));
let _e2366 = (_e1262.member.z - (_e1996 + (_e2035 * _e2275)));
let _e2371 = (((_e2291 * _e2291) + (_e2292 * _e2292)) + (_e2293 * _e2293));
let _e2374 = sqrt(select(0f, _e2371, (_e2371 > 0f)));
let _e2379 = (((_e2309 * _e2309) + (_e2310 * _e2310)) + (_e2311 * _e2311));
let _e2382 = sqrt(select(0f, _e2379, (_e2379 > 0f)));
let _e2397 = (1f / (((((_e1336 * _e1349) - (_e1337 * _e1348)) * _e1262.member_1.x) + (((_e1337 * _e1347) - (_e1335 * _e1349)) * _e1262.member_1.y)) + (((_e1335 * _e1348) - (_e1336 * _e1347)) * _e1262.member_1.z)));
let _e2411 = (((((_e2292 * _e1349) - (_e2293 * _e1348)) * _e1262.member_1.x) + (((_e2293 * _e1347) - (_e2291 * _e1349)) * _e1262.member_1.y)) + (((_e2291 * _e1348) - (_e2292 * _e1347)) * _e1262.member_1.z));
let _e2456 = (((((_e1336 * _e2311) - (_e1337 * _e2310)) * _e1262.member_1.x) + (((_e1337 * _e2309) - (_e1335 * _e2311)) * _e1262.member_1.y)) + (((_e1335 * _e2310) - (_e1336 * _e2309)) * _e1262.member_1.z));
let _e2460 = bitcast<f32>((bitcast<u32>((_e2411 * _e2397)) & 2147483647u));
let _e2463 = bitcast<f32>((bitcast<u32>(((((((_e2310 * _e1349) - (_e2311 * _e1348)) * _e1262.member_1.x) + (((_e2311 * _e1347) - (_e2309 * _e1349)) * _e1262.member_1.y)) + (((_e2309 * _e1348) - (_e2310 * _e1347)) * _e1262.member_1.z)) * _e2397)) & 2147483647u));
let _e2467 = bitcast<f32>((bitcast<u32>(((((((_e1336 * _e2293) - (_e1337 * _e2292)) * _e1262.member_1.x) + (((_e1337 * _e2291) - (_e1335 * _e2293)) * _e1262.member_1.y)) + (((_e1335 * _e2292) - (_e1336 * _e2291)) * _e1262.member_1.z)) * _e2397)) & 2147483647u));
let _e2470 = bitcast<f32>((bitcast<u32>((_e2456 * _e2397)) & 2147483647u));
if (((_e2460 + _e2463) < 1f) && ((_e2467 + _e2470) < 1f)) {
let _e2909 = ((((((_e2365 * _e1349) - (_e2366 * _e1348)) * _e1262.member_1.x) + (((_e2366 * _e1347) - (_e2364 * _e1349)) * _e1262.member_1.y)) + (((_e2364 * _e1348) - (_e2365 * _e1347)) * _e1262.member_1.z)) * _e2397);
let _e2924 = ((((((_e1336 * _e2366) - (_e1337 * _e2365)) * _e1262.member_1.x) + (((_e1337 * _e2364) - (_e1335 * _e2366)) * _e1262.member_1.y)) + (((_e1335 * _e2365) - (_e1336 * _e2364)) * _e1262.member_1.z)) * _e2397);
let _e2925 = (1e-4f * 1f);
let _e2927 = select(_e2463, _e2460, (_e2460 > _e2463));
let _e2929 = select(_e2925, _e2927, (_e2927 > _e2925));
let _e2931 = select(_e2463, _e2460, (_e2460 < _e2463));
let _e2933 = select(_e2925, _e2931, (_e2931 > _e2925));
let _e2935 = (0.5f * (_e2929 + _e2933));
let _e2936 = (0.5f / _e2933);
let _e2937 = (1f / _e2929);
let _e2938 = (1f / 1f);
let _e2939 = (0.5f * 1f);
let _e2940 = (_e2909 + _e2939);
let _e2941 = -(_e2940);
let _e2944 = (_e2935 - select(_e2941, _e2940, (_e2940 > _e2941)));
let _e2946 = select(0f, _e2944, (_e2944 > 0f));
let _e2948 = select(_e2933, _e2946, (_e2946 < _e2933));
let _e2951 = (_e2944 - _e2933);
let _e2955 = (((_e2948 * (_e2948 * _e2936)) + select(0f, _e2951, (_e2951 > 0f))) * _e2937);
let _e2959 = (_e2909 - _e2939);
let _e2960 = -(_e2959);
let _e2963 = (_e2935 - select(_e2960, _e2959, (_e2959 > _e2960)));
let _e2965 = select(0f, _e2963, (_e2963 > 0f));
let _e2967 = select(_e2933, _e2965, (_e2965 < _e2933));
let _e2970 = (_e2963 - _e2933);
let _e2974 = (((_e2967 * (_e2967 * _e2936)) + select(0f, _e2970, (_e2970 > 0f))) * _e2937);
let _e2981 = select(_e2470, _e2467, (_e2467 > _e2470));
let _e2983 = select(_e2925, _e2981, (_e2981 > _e2925));
let _e2985 = select(_e2470, _e2467, (_e2467 < _e2470));
let _e2987 = select(_e2925, _e2985, (_e2985 > _e2925));
let _e2989 = (0.5f * (_e2983 + _e2987));
let _e2990 = (0.5f / _e2987);
let _e2991 = (1f / _e2983);
let _e2992 = (_e2924 + _e2939);
let _e2993 = -(_e2992);
let _e2996 = (_e2989 - select(_e2993, _e2992, (_e2992 > _e2993)));
let _e2998 = select(0f, _e2996, (_e2996 > 0f));
let _e3000 = select(_e2987, _e2998, (_e2998 < _e2987));
let _e3003 = (_e2996 - _e2987);
let _e3007 = (((_e3000 * (_e3000 * _e2990)) + select(0f, _e3003, (_e3003 > 0f))) * _e2991);
let _e3011 = (_e2924 - _e2939);
let _e3012 = -(_e3011);
let _e3015 = (_e2989 - select(_e3012, _e3011, (_e3011 > _e3012)));
let _e3017 = select(0f, _e3015, (_e3015 > 0f));
let _e3019 = select(_e2987, _e3017, (_e3017 < _e2987));
let _e3022 = (_e3015 - _e2987);
let _e3026 = (((_e3019 * (_e3019 * _e2990)) + select(0f, _e3022, (_e3022 > 0f))) * _e2991);
phi_5320_ = ((((select(_e2955, (1f - _e2955), (_e2940 >= 0f)) - select(_e2974, (1f - _e2974), (_e2959 >= 0f))) * _e2938) * ((select(_e3007, (1f - _e3007), (_e2992 >= 0f)) - select(_e3026, (1f - _e3026), (_e3011 >= 0f))) * _e2938)) * bitcast<f32>((bitcast<u32>(_e2397) & 2147483647u)));
} else {
let _e2488 = (((((_e2292 * _e2311) - (_e2293 * _e2310)) * _e1262.member_1.x) + (((_e2293 * _e2309) - (_e2291 * _e2311)) * _e1262.member_1.y)) + (((_e2291 * _e2310) - (_e2292 * _e2309)) * _e1262.member_1.z));
let _e2489 = (1f / _e2488);
if (bitcast<f32>((bitcast<u32>(_e2488) & 2147483647u)) > ((0.5f * _e2374) * _e2382)) {
let _e2718 = ((((((_e2365 * _e2311) - (_e2366 * _e2310)) * _e1262.member_1.x) + (((_e2366 * _e2309) - (_e2364 * _e2311)) * _e1262.member_1.y)) + (((_e2364 * _e2310) - (_e2365 * _e2309)) * _e1262.member_1.z)) * _e2489);
let _e2733 = ((((((_e2292 * _e2366) - (_e2293 * _e2365)) * _e1262.member_1.x) + (((_e2293 * _e2364) - (_e2291 * _e2366)) * _e1262.member_1.y)) + (((_e2291 * _e2365) - (_e2292 * _e2364)) * _e1262.member_1.z)) * _e2489);
let _e2768 = bitcast<f32>((bitcast<u32>((_e2456 * _e2489)) & 2147483647u));
let _e2771 = bitcast<f32>((bitcast<u32>(((((((_e1348 * _e2311) - (_e1349 * _e2310)) * _e1262.member_1.x) + (((_e1349 * _e2309) - (_e1347 * _e2311)) * _e1262.member_1.y)) + (((_e1347 * _e2310) - (_e1348 * _e2309)) * _e1262.member_1.z)) * _e2489)) & 2147483647u));
let _e2773 = select(_e2771, _e2768, (_e2768 > _e2771));
let _e2775 = select(1e-3f, _e2773, (_e2773 > 1e-3f));
let _e2778 = bitcast<f32>((bitcast<u32>(((((((_e2292 * _e1337) - (_e2293 * _e1336)) * _e1262.member_1.x) + (((_e2293 * _e1335) - (_e2291 * _e1337)) * _e1262.member_1.y)) + (((_e2291 * _e1336) - (_e2292 * _e1335)) * _e1262.member_1.z)) * _e2489)) & 2147483647u));
let _e2781 = bitcast<f32>((bitcast<u32>((_e2411 * _e2489)) & 2147483647u));
let _e2783 = select(_e2781, _e2778, (_e2778 > _e2781));
let _e2785 = select(1e-3f, _e2783, (_e2783 > 1e-3f));
let _e2786 = (1e-4f * _e2775);
let _e2788 = select(_e2786, 1f, (1f > _e2786));
let _e2790 = select(_e2786, 0f, (0f > _e2786));
let _e2792 = (0.5f * (_e2788 + _e2790));
let _e2793 = (0.5f / _e2790);
let _e2794 = (1f / _e2788);
let _e2796 = (0.5f * _e2775);
let _e2797 = (_e2718 + _e2796);
let _e2798 = -(_e2797);
let _e2801 = (_e2792 - select(_e2798, _e2797, (_e2797 > _e2798)));
let _e2803 = select(0f, _e2801, (_e2801 > 0f));
let _e2805 = select(_e2790, _e2803, (_e2803 < _e2790));
let _e2808 = (_e2801 - _e2790);
let _e2812 = (((_e2805 * (_e2805 * _e2793)) + select(0f, _e2808, (_e2808 > 0f))) * _e2794);
let _e2816 = (_e2718 - _e2796);
let _e2817 = -(_e2816);
let _e2820 = (_e2792 - select(_e2817, _e2816, (_e2816 > _e2817)));
let _e2822 = select(0f, _e2820, (_e2820 > 0f));
let _e2824 = select(_e2790, _e2822, (_e2822 < _e2790));
let _e2827 = (_e2820 - _e2790);
let _e2831 = (((_e2824 * (_e2824 * _e2793)) + select(0f, _e2827, (_e2827 > 0f))) * _e2794);
let _e2837 = (1e-4f * _e2785);
let _e2839 = select(_e2837, 1f, (1f > _e2837));
let _e2841 = select(_e2837, 0f, (0f > _e2837));
let _e2843 = (0.5f * (_e2839 + _e2841));
let _e2844 = (0.5f / _e2841);
let _e2845 = (1f / _e2839);
let _e2847 = (0.5f * _e2785);
let _e2848 = (_e2733 + _e2847);
let _e2849 = -(_e2848);
let _e2852 = (_e2843 - select(_e2849, _e2848, (_e2848 > _e2849)));
let _e2854 = select(0f, _e2852, (_e2852 > 0f));
let _e2856 = select(_e2841, _e2854, (_e2854 < _e2841));
let _e2859 = (_e2852 - _e2841);
let _e2863 = (((_e2856 * (_e2856 * _e2844)) + select(0f, _e2859, (_e2859 > 0f))) * _e2845);
let _e2867 = (_e2733 - _e2847);
let _e2868 = -(_e2867);
let _e2871 = (_e2843 - select(_e2868, _e2867, (_e2867 > _e2868)));
let _e2873 = select(0f, _e2871, (_e2871 > 0f));
let _e2875 = select(_e2841, _e2873, (_e2873 < _e2841));
let _e2878 = (_e2871 - _e2841);
let _e2882 = (((_e2875 * (_e2875 * _e2844)) + select(0f, _e2878, (_e2878 > 0f))) * _e2845);
phi_5319_ = ((((select(_e2812, (1f - _e2812), (_e2797 >= 0f)) - select(_e2831, (1f - _e2831), (_e2816 >= 0f))) * (1f / _e2775)) * ((select(_e2863, (1f - _e2863), (_e2848 >= 0f)) - select(_e2882, (1f - _e2882), (_e2867 >= 0f))) * (1f / _e2785))) * bitcast<f32>((bitcast<u32>(_e2489) & 2147483647u)));
} else {
let _e2496 = (_e2374 >= _e2382);
let _e2497 = select(_e2309, _e2291, _e2496);
let _e2498 = select(_e2310, _e2292, _e2496);
let _e2499 = select(_e2311, _e2293, _e2496);
let _e2500 = select(_e2291, _e2309, _e2496);
let _e2501 = select(_e2292, _e2310, _e2496);
let _e2502 = select(_e2293, _e2311, _e2496);
let _e2507 = (((_e2497 * _e2497) + (_e2498 * _e2498)) + (_e2499 * _e2499));
let _e2510 = sqrt(select(0f, _e2507, (_e2507 > 0f)));
let _e2513 = (1f / select(1e-30f, _e2510, (_e2510 > 1e-30f)));
let _e2514 = (_e2497 * _e2513);
let _e2515 = (_e2498 * _e2513);
let _e2516 = (_e2499 * _e2513);
let _e2519 = ((_e1262.member_1.y * _e2516) - (_e1262.member_1.z * _e2515));
let _e2522 = ((_e1262.member_1.z * _e2514) - (_e1262.member_1.x * _e2516));
let _e2525 = ((_e1262.member_1.x * _e2515) - (_e1262.member_1.y * _e2514));
let _e2533 = bitcast<f32>((bitcast<u32>((((_e1335 * _e2514) + (_e1336 * _e2515)) + (_e1337 * _e2516))) & 2147483647u));
let _e2541 = bitcast<f32>((bitcast<u32>((((_e1347 * _e2514) + (_e1348 * _e2515)) + (_e1349 * _e2516))) & 2147483647u));
let _e2543 = select(_e2541, _e2533, (_e2533 > _e2541));
let _e2544 = (1e-3f * _e2510);
let _e2546 = select(_e2544, _e2543, (_e2543 > _e2544));
let _e2554 = bitcast<f32>((bitcast<u32>((((_e1335 * _e2519) + (_e1336 * _e2522)) + (_e1337 * _e2525))) & 2147483647u));
let _e2562 = bitcast<f32>((bitcast<u32>((((_e1347 * _e2519) + (_e1348 * _e2522)) + (_e1349 * _e2525))) & 2147483647u));
let _e2564 = select(_e2562, _e2554, (_e2554 > _e2562));
let _e2566 = select(_e2544, _e2564, (_e2564 > _e2544));
let _e2571 = (((_e2364 * _e2514) + (_e2365 * _e2515)) + (_e2366 * _e2516));
let _e2579 = bitcast<f32>((bitcast<u32>((((_e2500 * _e2514) + (_e2501 * _e2515)) + (_e2502 * _e2516))) & 2147483647u));
let _e2580 = (1e-4f * _e2546);
let _e2582 = select(_e2579, _e2510, (_e2510 > _e2579));
let _e2584 = select(_e2580, _e2582, (_e2582 > _e2580));
let _e2586 = select(_e2579, _e2510, (_e2510 < _e2579));
let _e2588 = select(_e2580, _e2586, (_e2586 > _e2580));
let _e2590 = (0.5f * (_e2584 + _e2588));
let _e2591 = (0.5f / _e2588);
let _e2592 = (1f / _e2584);
let _e2594 = (0.5f * _e2546);
let _e2595 = (_e2571 + _e2594);
let _e2596 = -(_e2595);
let _e2599 = (_e2590 - select(_e2596, _e2595, (_e2595 > _e2596)));
let _e2601 = select(0f, _e2599, (_e2599 > 0f));
let _e2603 = select(_e2588, _e2601, (_e2601 < _e2588));
let _e2606 = (_e2599 - _e2588);
let _e2610 = (((_e2603 * (_e2603 * _e2591)) + select(0f, _e2606, (_e2606 > 0f))) * _e2592);
let _e2614 = (_e2571 - _e2594);
let _e2615 = -(_e2614);
let _e2618 = (_e2590 - select(_e2615, _e2614, (_e2614 > _e2615)));
let _e2620 = select(0f, _e2618, (_e2618 > 0f));
let _e2622 = select(_e2588, _e2620, (_e2620 < _e2588));
let _e2625 = (_e2618 - _e2588);
let _e2629 = (((_e2622 * (_e2622 * _e2591)) + select(0f, _e2625, (_e2625 > 0f))) * _e2592);
let _e2639 = (((_e2364 * _e2519) + (_e2365 * _e2522)) + (_e2366 * _e2525));
let _e2647 = bitcast<f32>((bitcast<u32>((((_e2500 * _e2519) + (_e2501 * _e2522)) + (_e2502 * _e2525))) & 2147483647u));
let _e2648 = (1e-4f * _e2566);
let _e2650 = select(0f, _e2647, (_e2647 > 0f));
let _e2652 = select(_e2648, _e2650, (_e2650 > _e2648));
let _e2654 = select(0f, _e2647, (_e2647 < 0f));
let _e2656 = select(_e2648, _e2654, (_e2654 > _e2648));
let _e2658 = (0.5f * (_e2652 + _e2656));
let _e2659 = (0.5f / _e2656);
let _e2660 = (1f / _e2652);
let _e2662 = (0.5f * _e2566);
let _e2663 = (_e2639 + _e2662);
let _e2664 = -(_e2663);
let _e2667 = (_e2658 - select(_e2664, _e2663, (_e2663 > _e2664)));
let _e2669 = select(0f, _e2667, (_e2667 > 0f));
let _e2671 = select(_e2656, _e2669, (_e2669 < _e2656));
let _e2674 = (_e2667 - _e2656);
let _e2678 = (((_e2671 * (_e2671 * _e2659)) + select(0f, _e2674, (_e2674 > 0f))) * _e2660);
let _e2682 = (_e2639 - _e2662);
let _e2683 = -(_e2682);
let _e2686 = (_e2658 - select(_e2683, _e2682, (_e2682 > _e2683)));
let _e2688 = select(0f, _e2686, (_e2686 > 0f));
let _e2690 = select(_e2656, _e2688, (_e2688 < _e2656));
let _e2693 = (_e2686 - _e2656);
let _e2697 = (((_e2690 * (_e2690 * _e2659)) + select(0f, _e2693, (_e2693 > 0f))) * _e2660);
phi_5319_ = (((select(_e2610, (1f - _e2610), (_e2595 >= 0f)) - select(_e2629, (1f - _e2629), (_e2614 >= 0f))) * (1f / _e2546)) * ((select(_e2678, (1f - _e2678), (_e2663 >= 0f)) - select(_e2697, (1f - _e2697), (_e2682 >= 0f))) * (1f / _e2566)));
}
let _e2894 = phi_5319_;
phi_5320_ = _e2894;
}
let _e3038 = phi_5320_;
let _e3039 = (_e3038 <= 0f);
if _e3039 {
phi_6389_ = vec3<f32>();
} else {
let _e3042 = (select(_e2243, _e2275, (_e2275 < _e2243)) - 0f);
let _e3046 = global_1.member.member_13.member_6;
if (_e3046 == 0u) {
phi_6056_ = _e3042;
} else {
let _e3049 = (_e3042 / f32(_e3046));
phi_5343_ = 0u;
phi_5346_ = 0f;
loop {
let _e3051 = phi_5343_;
let _e3053 = phi_5346_;
local_37 = _e3053;
let _e3056 = ((_e3051 < _e3046) && (_e3042 > 0f));
if _e3056 {
let _e3059 = (0f + (_e3049 * f32(_e3051)));
let _e3060 = (_e3059 + _e3049);
let _e3062 = (0.5f * (_e3059 + _e3060));
let _e3063 = (_e3060 - _e3059);
let _e3064 = (0.28867513f * _e3063);
let _e3065 = (_e3062 - _e3064);
let _e3075 = global_1.member.member_13.member_7;
let _e3076 = bitcast<i32>(_e3075);
let _e3080 = global_1.member.member_13.member_8;
let _e3081 = bitcast<i32>(_e3080);
let _e3085 = global_1.member.member_13.member_9;
let _e3086 = bitcast<i32>(_e3085);
let _e3090 = global_1.member.member_13.member_4;
let _e3097 = global_1.member.member_13.member_5;
let _e3101 = f32(_e3076);
let _e3103 = (_e3097.member - _e3090.member);
let _e3106 = (((((_e1971 + (_e2009 * _e3065)) - _e3090.member) / _e3103) * _e3101) - 0.5f);
let _e3107 = (_e3101 - 1f);
let _e3109 = select(0f, _e3106, (_e3106 > 0f));
let _e3111 = select(_e3107, _e3109, (_e3109 < _e3107));
let _e3112 = f32(_e3081);
let _e3114 = (_e3097.member_1 - _e3090.member_1);
let _e3117 = (((((_e1983 + (_e2022 * _e3065)) - _e3090.member_1) / _e3114) * _e3112) - 0.5f);
let _e3118 = (_e3112 - 1f);
let _e3120 = select(0f, _e3117, (_e3117 > 0f));
let _e3122 = select(_e3118, _e3120, (_e3120 < _e3118));
let _e3123 = f32(_e3086);
let _e3125 = (_e3097.member_2 - _e3090.member_2);
let _e3128 = (((((_e1996 + (_e2035 * _e3065)) - _e3090.member_2) / _e3125) * _e3123) - 0.5f);
let _e3129 = (_e3123 - 1f);
let _e3131 = select(0f, _e3128, (_e3128 > 0f));
let _e3133 = select(_e3129, _e3131, (_e3131 < _e3129));
let _e3135 = select(0f, _e3111, (_e3111 > 0f));
let _e3137 = select(1e6f, _e3135, (_e3135 < 1e6f));
let _e3144 = select(0i, select(select(i32(_e3137), i32(-2147483648), (_e3137 < -2147483600f)), 2147483647i, (_e3137 > 2147483500f)), (_e3137 == _e3137));
let _e3148 = (_e3144 - select(0i, 1i, (_e3137 < f32(_e3144))));
let _e3150 = select(0f, _e3122, (_e3122 > 0f));
let _e3152 = select(1e6f, _e3150, (_e3150 < 1e6f));
let _e3159 = select(0i, select(select(i32(_e3152), i32(-2147483648), (_e3152 < -2147483600f)), 2147483647i, (_e3152 > 2147483500f)), (_e3152 == _e3152));
let _e3163 = (_e3159 - select(0i, 1i, (_e3152 < f32(_e3159))));
let _e3165 = select(0f, _e3133, (_e3133 > 0f));
let _e3167 = select(1e6f, _e3165, (_e3165 < 1e6f));
let _e3174 = select(0i, select(select(i32(_e3167), i32(-2147483648), (_e3167 < -2147483600f)), 2147483647i, (_e3167 > 2147483500f)), (_e3167 == _e3167));
let _e3178 = (_e3174 - select(0i, 1i, (_e3167 < f32(_e3174))));
let _e3182 = (_e3122 - f32(_e3163));
let _e3184 = (_e3133 - f32(_e3178));
local_6 = (_e3111 - f32(_e3148));
let _e3185 = (_e3148 + 1i);
let _e3187 = select(_e3185, 0i, (_e3185 < 0i));
if (_e3187 >= _e3076) {
phi_5481_ = (_e3076 - 1i);
} else {
phi_5481_ = _e3187;
}
let _e3191 = phi_5481_;
local_7 = (_e3191 - _e3148);
let _e3193 = (_e3163 + 1i);
let _e3195 = select(_e3193, 0i, (_e3193 < 0i));
if (_e3195 >= _e3081) {
phi_5494_ = (_e3081 - 1i);
} else {
phi_5494_ = _e3195;
}
let _e3199 = phi_5494_;
let _e3201 = ((_e3199 - _e3163) * _e3076);
let _e3202 = (_e3178 + 1i);
let _e3204 = select(_e3202, 0i, (_e3202 < 0i));
if (_e3204 >= _e3086) {
phi_5508_ = (_e3086 - 1i);
} else {
phi_5508_ = _e3204;
}
let _e3208 = phi_5508_;
let _e3215 = global_1.member.member_13.member_10;
let _e3216 = bitcast<i32>(_e3215);
let _e3221 = ((_e3216 + (((_e3178 * _e3081) + _e3163) * _e3076)) + _e3148);
let _e3223 = select(_e1285, _e3221, (_e3221 < _e1285));
let _e3228 = global_8.member[bitcast<u32>(select(0i, _e3223, (_e3223 > 0i)))];
let _e3229 = local_6;
let _e3232 = local_7;
let _e3233 = (_e3221 + _e3232);
let _e3235 = select(_e1285, _e3233, (_e3233 < _e1285));
let _e3240 = global_8.member[bitcast<u32>(select(0i, _e3235, (_e3235 > 0i)))];
let _e3241 = local_6;
let _e3244 = (1f - _e3182);
let _e3246 = (_e3221 + _e3201);
let _e3248 = select(_e1285, _e3246, (_e3246 < _e1285));
let _e3253 = global_8.member[bitcast<u32>(select(0i, _e3248, (_e3248 > 0i)))];
let _e3254 = local_6;
let _e3257 = local_7;
let _e3258 = (_e3246 + _e3257);
let _e3260 = select(_e1285, _e3258, (_e3258 < _e1285));
let _e3265 = global_8.member[bitcast<u32>(select(0i, _e3260, (_e3260 > 0i)))];
let _e3266 = local_6;
let _e3271 = (_e3221 + (((_e3208 - _e3178) * _e3076) * _e3081));
let _e3273 = select(_e1285, _e3271, (_e3271 < _e1285));
let _e3278 = global_8.member[bitcast<u32>(select(0i, _e3273, (_e3273 > 0i)))];
let _e3279 = local_6;
let _e3282 = local_7;
let _e3283 = (_e3271 + _e3282);
let _e3285 = select(_e1285, _e3283, (_e3283 < _e1285));
let _e3290 = global_8.member[bitcast<u32>(select(0i, _e3285, (_e3285 > 0i)))];
let _e3291 = local_6;
let _e3295 = (_e3271 + _e3201);
let _e3297 = select(_e1285, _e3295, (_e3295 < _e1285));
let _e3302 = global_8.member[bitcast<u32>(select(0i, _e3297, (_e3297 > 0i)))];
let _e3303 = local_6;
let _e3306 = local_7;
let _e3307 = (_e3295 + _e3306);
let _e3309 = select(_e1285, _e3307, (_e3307 < _e1285));
let _e3314 = global_8.member[bitcast<u32>(select(0i, _e3309, (_e3309 > 0i)))];
let _e3315 = local_6;
let _e3324 = (_e3062 + _e3064);
let _e3334 = (((((_e1971 + (_e2009 * _e3324)) - _e3090.member) / _e3103) * _e3101) - 0.5f);
let _e3336 = select(0f, _e3334, (_e3334 > 0f));
let _e3338 = select(_e3107, _e3336, (_e3336 < _e3107));
let _e3342 = (((((_e1983 + (_e2022 * _e3324)) - _e3090.member_1) / _e3114) * _e3112) - 0.5f);
let _e3344 = select(0f, _e3342, (_e3342 > 0f));
let _e3346 = select(_e3118, _e3344, (_e3344 < _e3118));
let _e3350 = (((((_e1996 + (_e2035 * _e3324)) - _e3090.member_2) / _e3125) * _e3123) - 0.5f);
let _e3352 = select(0f, _e3350, (_e3350 > 0f));
let _e3354 = select(_e3129, _e3352, (_e3352 < _e3129));
let _e3356 = select(0f, _e3338, (_e3338 > 0f));
let _e3358 = select(1e6f, _e3356, (_e3356 < 1e6f));
let _e3365 = select(0i, select(select(i32(_e3358), i32(-2147483648), (_e3358 < -2147483600f)), 2147483647i, (_e3358 > 2147483500f)), (_e3358 == _e3358));
let _e3369 = (_e3365 - select(0i, 1i, (_e3358 < f32(_e3365))));
let _e3371 = select(0f, _e3346, (_e3346 > 0f));
let _e3373 = select(1e6f, _e3371, (_e3371 < 1e6f));
let _e3380 = select(0i, select(select(i32(_e3373), i32(-2147483648), (_e3373 < -2147483600f)), 2147483647i, (_e3373 > 2147483500f)), (_e3373 == _e3373));
let _e3384 = (_e3380 - select(0i, 1i, (_e3373 < f32(_e3380))));
let _e3386 = select(0f, _e3354, (_e3354 > 0f));
let _e3388 = select(1e6f, _e3386, (_e3386 < 1e6f));
let _e3395 = select(0i, select(select(i32(_e3388), i32(-2147483648), (_e3388 < -2147483600f)), 2147483647i, (_e3388 > 2147483500f)), (_e3388 == _e3388));
let _e3399 = (_e3395 - select(0i, 1i, (_e3388 < f32(_e3395))));
let _e3403 = (_e3346 - f32(_e3384));
let _e3405 = (_e3354 - f32(_e3399));
local_4 = (_e3338 - f32(_e3369));
let _e3406 = (_e3369 + 1i);
let _e3408 = select(_e3406, 0i, (_e3406 < 0i));
if (_e3408 >= _e3076) {
phi_5824_ = (_e3076 - 1i);
} else {
phi_5824_ = _e3408;
}
let _e3412 = phi_5824_;
local_5 = (_e3412 - _e3369);
let _e3414 = (_e3384 + 1i);
let _e3416 = select(_e3414, 0i, (_e3414 < 0i));
if (_e3416 >= _e3081) {
phi_5837_ = (_e3081 - 1i);
} else {
phi_5837_ = _e3416;
}
let _e3420 = phi_5837_;
let _e3422 = ((_e3420 - _e3384) * _e3076);
let _e3423 = (_e3399 + 1i);
let _e3425 = select(_e3423, 0i, (_e3423 < 0i));
if (_e3425 >= _e3086) {
phi_5851_ = (_e3086 - 1i);
} else {
phi_5851_ = _e3425;
}
let _e3429 = phi_5851_;
let _e3437 = ((_e3216 + (((_e3399 * _e3081) + _e3384) * _e3076)) + _e3369);
let _e3439 = select(_e1285, _e3437, (_e3437 < _e1285));
let _e3444 = global_8.member[bitcast<u32>(select(0i, _e3439, (_e3439 > 0i)))];
let _e3445 = local_4;
let _e3448 = local_5;
let _e3449 = (_e3437 + _e3448);
let _e3451 = select(_e1285, _e3449, (_e3449 < _e1285));
let _e3456 = global_8.member[bitcast<u32>(select(0i, _e3451, (_e3451 > 0i)))];
let _e3457 = local_4;
let _e3460 = (1f - _e3403);
let _e3462 = (_e3437 + _e3422);
let _e3464 = select(_e1285, _e3462, (_e3462 < _e1285));
let _e3469 = global_8.member[bitcast<u32>(select(0i, _e3464, (_e3464 > 0i)))];
let _e3470 = local_4;
let _e3473 = local_5;
let _e3474 = (_e3462 + _e3473);
let _e3476 = select(_e1285, _e3474, (_e3474 < _e1285));
let _e3481 = global_8.member[bitcast<u32>(select(0i, _e3476, (_e3476 > 0i)))];
let _e3482 = local_4;
let _e3487 = (_e3437 + (((_e3429 - _e3399) * _e3076) * _e3081));
let _e3489 = select(_e1285, _e3487, (_e3487 < _e1285));
let _e3494 = global_8.member[bitcast<u32>(select(0i, _e3489, (_e3489 > 0i)))];
let _e3495 = local_4;
let _e3498 = local_5;
let _e3499 = (_e3487 + _e3498);
let _e3501 = select(_e1285, _e3499, (_e3499 < _e1285));
let _e3506 = global_8.member[bitcast<u32>(select(0i, _e3501, (_e3501 > 0i)))];
let _e3507 = local_4;
let _e3511 = (_e3487 + _e3422);
let _e3513 = select(_e1285, _e3511, (_e3511 < _e1285));
let _e3518 = global_8.member[bitcast<u32>(select(0i, _e3513, (_e3513 > 0i)))];
let _e3519 = local_4;
let _e3522 = local_5;
let _e3523 = (_e3511 + _e3522);
let _e3525 = select(_e1285, _e3523, (_e3523 < _e1285));
let _e3530 = global_8.member[bitcast<u32>(select(0i, _e3525, (_e3525 > 0i)))];
let _e3531 = local_4;
phi_5344_ = (_e3051 + 1u);
phi_5347_ = (_e3053 + ((0.5f * (((((((_e3228 * (1f - _e3229)) + (_e3240 * _e3241)) * _e3244) + (((_e3253 * (1f - _e3254)) + (_e3265 * _e3266)) * _e3182)) * (1f - _e3184)) + (((((_e3278 * (1f - _e3279)) + (_e3290 * _e3291)) * _e3244) + (((_e3302 * (1f - _e3303)) + (_e3314 * _e3315)) * _e3182)) * _e3184)) + ((((((_e3444 * (1f - _e3445)) + (_e3456 * _e3457)) * _e3460) + (((_e3469 * (1f - _e3470)) + (_e3481 * _e3482)) * _e3403)) * (1f - _e3405)) + (((((_e3494 * (1f - _e3495)) + (_e3506 * _e3507)) * _e3460) + (((_e3518 * (1f - _e3519)) + (_e3530 * _e3531)) * _e3403)) * _e3405)))) * _e3063));
} else {
phi_5344_ = u32();
phi_5347_ = f32();
}
let _e3546 = phi_5344_;
let _e3548 = phi_5347_;
continue;
continuing {
phi_5343_ = _e3546;
phi_5346_ = _e3548;
break if !(_e3056);
}
}
let _e4699 = local_37;
phi_6056_ = _e4699;
}
let _e3551 = phi_6056_;
let _e3564 = (0.25f * bitcast<f32>((bitcast<u32>((((_e1262.member_2.x * _e2009) + (_e1262.member_2.y * _e2022)) + (_e1262.member_2.z * _e2035))) & 2147483647u)));
let _e3571 = (((_e1262.member_1.x * _e464) + (_e1262.member_1.y * _e475)) + (_e1262.member_1.z * _e486));
let _e3573 = select(1f, -1f, (_e3571 > 0f));
let _e3581 = select(_e3573, -(_e3573), ((((_e1262.member_2.x * _e1262.member_1.x) + (_e1262.member_2.y * _e1262.member_1.y)) + (_e1262.member_2.z * _e1262.member_1.z)) < 0f));
let _e3582 = (_e1262.member_2.x * _e3581);
let _e3583 = (_e1262.member_2.y * _e3581);
let _e3584 = (_e1262.member_2.z * _e3581);
let _e3593 = ((((_e3582 * _e464) + (_e3583 * _e475)) + (_e3584 * _e486)) > 0f);
let _e3602 = -((((select(_e3582, (_e1262.member_1.x * _e3573), _e3593) * _e2009) + (select(_e3583, (_e1262.member_1.y * _e3573), _e3593) * _e2022)) + (select(_e3584, (_e1262.member_1.z * _e3573), _e3593) * _e2035)));
let _e3607 = -(_e3602);
let _e3617 = global_1.member.member_13.member;
let _e3622 = -((_e3617.member * _e3551));
let _e3624 = select(-87f, _e3622, (_e3622 > -87f));
let _e3626 = select(88f, _e3624, (_e3624 < 88f));
let _e3628 = ((_e3626 * 1.442695f) + 0.5f);
let _e3630 = select(-127f, _e3628, (_e3628 > -127f));
let _e3632 = select(128f, _e3630, (_e3630 < 128f));
let _e3639 = select(0i, select(select(i32(_e3632), i32(-2147483648), (_e3632 < -2147483600f)), 2147483647i, (_e3632 > 2147483500f)), (_e3632 == _e3632));
let _e3643 = (_e3639 - select(0i, 1i, (_e3632 < f32(_e3639))));
let _e3644 = f32(_e3643);
let _e3648 = ((_e3626 - (_e3644 * 0.6933594f)) - (_e3644 * -2.1219444e-4f));
let _e3670 = -((_e3617.member_1 * _e3551));
let _e3672 = select(-87f, _e3670, (_e3670 > -87f));
let _e3674 = select(88f, _e3672, (_e3672 < 88f));
let _e3676 = ((_e3674 * 1.442695f) + 0.5f);
let _e3678 = select(-127f, _e3676, (_e3676 > -127f));
let _e3680 = select(128f, _e3678, (_e3678 < 128f));
let _e3687 = select(0i, select(select(i32(_e3680), i32(-2147483648), (_e3680 < -2147483600f)), 2147483647i, (_e3680 > 2147483500f)), (_e3680 == _e3680));
let _e3691 = (_e3687 - select(0i, 1i, (_e3680 < f32(_e3687))));
let _e3692 = f32(_e3691);
let _e3696 = ((_e3674 - (_e3692 * 0.6933594f)) - (_e3692 * -2.1219444e-4f));
let _e3718 = -((_e3617.member_2 * _e3551));
let _e3720 = select(-87f, _e3718, (_e3718 > -87f));
let _e3722 = select(88f, _e3720, (_e3720 < 88f));
let _e3724 = ((_e3722 * 1.442695f) + 0.5f);
let _e3726 = select(-127f, _e3724, (_e3724 > -127f));
let _e3728 = select(128f, _e3726, (_e3726 < 128f));
let _e3735 = select(0i, select(select(i32(_e3728), i32(-2147483648), (_e3728 < -2147483600f)), 2147483647i, (_e3728 > 2147483500f)), (_e3728 == _e3728));
let _e3739 = (_e3735 - select(0i, 1i, (_e3728 < f32(_e3735))));
let _e3740 = f32(_e3739);
let _e3744 = ((_e3722 - (_e3740 * 0.6933594f)) - (_e3740 * -2.1219444e-4f));
let _e3770 = ((_e3038 * (select((select(0f, _e3607, (_e3607 > 0f)) * _e1262.member_4), select(0f, _e3602, (_e3602 > 0f)), ((_e2261 * _e3571) > 0f)) / select(_e3564, _e2264, (_e2264 > _e3564)))) * (1f / 3.1415927f));
phi_6389_ = vec3<f32>(((_e2204 * ((1f + (_e3648 * (1f + (_e3648 * (0.5f + (_e3648 * (0.16666667f + (_e3648 * (0.041666668f + (_e3648 * (0.008333334f + (_e3648 * (0.001388889f + (_e3648 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3643 + 127i)) << bitcast<u32>(23i))))) * _e3770), ((_e2217 * ((1f + (_e3696 * (1f + (_e3696 * (0.5f + (_e3696 * (0.16666667f + (_e3696 * (0.041666668f + (_e3696 * (0.008333334f + (_e3696 * (0.001388889f + (_e3696 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3691 + 127i)) << bitcast<u32>(23i))))) * _e3770), ((_e2230 * ((1f + (_e3744 * (1f + (_e3744 * (0.5f + (_e3744 * (0.16666667f + (_e3744 * (0.041666668f + (_e3744 * (0.008333334f + (_e3744 * (0.001388889f + (_e3744 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3739 + 127i)) << bitcast<u32>(23i))))) * _e3770));
}
let _e3776 = phi_6389_;
phi_6390_ = _e3776;
phi_6391_ = _e3039;
}
let _e3778 = phi_6390_;
let _e3780 = phi_6391_;
phi_6395_ = _e3778;
phi_6396_ = _e3780;
}
let _e3782 = phi_6395_;
let _e3784 = phi_6396_;
phi_6412_ = (_e1893 + select(_e3782, vec3<f32>(0f, 0f, 0f), vec3(_e3784)));
}
let _e3789 = phi_6412_;
phi_3363_ = _e3789;
phi_3366_ = (_e1895 + 1u);
}
let _e3792 = phi_3363_;
let _e3794 = phi_3366_;
continue;
continuing {
phi_3362_ = _e3792;
phi_3365_ = _e3794;
break if !(select(true, false, _e1899));
}
}
let _e3797 = local_17.member_1;
phi_6422_ = type_17(_e1541.member, (_e1541.member_1 + 1u));
loop {
let _e3801 = phi_6422_;
local_39 = _e3801;
let _e3807 = (((_e3801.member_1 & 3u) == 0u) && (_e3801.member < _e3797));
if _e3807 {
phi_6423_ = type_17((_e3801.member + 1u), (_e3801.member_1 >> bitcast<u32>(2i)));
} else {
phi_6423_ = type_17();
}
let _e3813 = phi_6423_;
continue;
continuing {
phi_6422_ = _e3813;
break if !(_e3807);
}
}
let _e4712 = local_38;
phi_6444_ = _e4712;
let _e4715 = local_39;
phi_6445_ = _e4715;
}
let _e3820 = phi_6444_;
let _e3822 = phi_6445_;
phi_2770_ = _e3820;
phi_2773_ = _e3822;
} else {
phi_2770_ = vec3<f32>();
phi_2773_ = type_17();
}
let _e3824 = phi_2770_;
let _e3826 = phi_2773_;
continue;
continuing {
phi_2769_ = _e3824;
phi_2772_ = _e3826;
break if !(_e1549);
}
}
let _e3835 = (1f / select(_e464, select(1e-12f, -1e-12f, (_e464 < 0f)), (bitcast<f32>((bitcast<u32>(_e464) & 2147483647u)) < 1e-12f)));
let _e3843 = (1f / select(_e475, select(1e-12f, -1e-12f, (_e475 < 0f)), (bitcast<f32>((bitcast<u32>(_e475) & 2147483647u)) < 1e-12f)));
let _e3851 = (1f / select(_e486, select(1e-12f, -1e-12f, (_e486 < 0f)), (bitcast<f32>((bitcast<u32>(_e486) & 2147483647u)) < 1e-12f)));
let _e3855 = global_1.member.member_13.member_4;
let _e3862 = global_1.member.member_13.member_5;
let _e3867 = ((_e3855.member - _e781) * _e3835);
let _e3869 = ((_e3862.member - _e781) * _e3835);
let _e3871 = ((_e3855.member_1 - _e782) * _e3843);
let _e3873 = ((_e3862.member_1 - _e782) * _e3843);
let _e3875 = ((_e3855.member_2 - _e783) * _e3851);
let _e3877 = ((_e3862.member_2 - _e783) * _e3851);
let _e3879 = select(_e3869, _e3867, (_e3867 < _e3869));
let _e3881 = select(_e3873, _e3871, (_e3871 < _e3873));
let _e3883 = select(_e3881, _e3879, (_e3879 > _e3881));
let _e3885 = select(_e3877, _e3875, (_e3875 < _e3877));
let _e3887 = select(_e3885, _e3883, (_e3883 > _e3885));
let _e3889 = select(_e3869, _e3867, (_e3867 > _e3869));
let _e3891 = select(_e3873, _e3871, (_e3871 > _e3873));
let _e3893 = select(_e3891, _e3889, (_e3889 < _e3891));
let _e3895 = select(_e3877, _e3875, (_e3875 > _e3877));
let _e3897 = select(_e3895, _e3893, (_e3893 < _e3895));
let _e3899 = select(0f, _e3887, (_e3887 > 0f));
let _e3901 = select(_e784, _e3897, (_e3897 < _e784));
let _e3902 = (_e3901 > _e3899);
let _e3903 = select(0f, _e3899, _e3902);
let _e3905 = (select(0f, _e3901, _e3902) - _e3903);
let _e3909 = global_1.member.member_13.member_6;
if (_e3909 == 0u) {
phi_7306_ = _e3905;
} else {
let _e3912 = (_e3905 / f32(_e3909));
phi_6593_ = 0u;
phi_6596_ = 0f;
loop {
let _e3914 = phi_6593_;
let _e3916 = phi_6596_;
local_40 = _e3916;
let _e3919 = ((_e3914 < _e3909) && (_e3905 > 0f));
if _e3919 {
let _e3922 = (_e3903 + (_e3912 * f32(_e3914)));
let _e3923 = (_e3922 + _e3912);
let _e3925 = (0.5f * (_e3922 + _e3923));
let _e3926 = (_e3923 - _e3922);
let _e3927 = (0.28867513f * _e3926);
let _e3928 = (_e3925 - _e3927);
let _e3938 = global_1.member.member_13.member_7;
let _e3939 = bitcast<i32>(_e3938);
let _e3943 = global_1.member.member_13.member_8;
let _e3944 = bitcast<i32>(_e3943);
let _e3948 = global_1.member.member_13.member_9;
let _e3949 = bitcast<i32>(_e3948);
let _e3950 = f32(_e3939);
let _e3952 = (_e3862.member - _e3855.member);
let _e3955 = (((((_e781 + (_e464 * _e3928)) - _e3855.member) / _e3952) * _e3950) - 0.5f);
let _e3956 = (_e3950 - 1f);
let _e3958 = select(0f, _e3955, (_e3955 > 0f));
let _e3960 = select(_e3956, _e3958, (_e3958 < _e3956));
let _e3961 = f32(_e3944);
let _e3963 = (_e3862.member_1 - _e3855.member_1);
let _e3966 = (((((_e782 + (_e475 * _e3928)) - _e3855.member_1) / _e3963) * _e3961) - 0.5f);
let _e3967 = (_e3961 - 1f);
let _e3969 = select(0f, _e3966, (_e3966 > 0f));
let _e3971 = select(_e3967, _e3969, (_e3969 < _e3967));
let _e3972 = f32(_e3949);
let _e3974 = (_e3862.member_2 - _e3855.member_2);
let _e3977 = (((((_e783 + (_e486 * _e3928)) - _e3855.member_2) / _e3974) * _e3972) - 0.5f);
let _e3978 = (_e3972 - 1f);
let _e3980 = select(0f, _e3977, (_e3977 > 0f));
let _e3982 = select(_e3978, _e3980, (_e3980 < _e3978));
let _e3984 = select(0f, _e3960, (_e3960 > 0f));
let _e3986 = select(1e6f, _e3984, (_e3984 < 1e6f));
let _e3993 = select(0i, select(select(i32(_e3986), i32(-2147483648), (_e3986 < -2147483600f)), 2147483647i, (_e3986 > 2147483500f)), (_e3986 == _e3986));
let _e3997 = (_e3993 - select(0i, 1i, (_e3986 < f32(_e3993))));
let _e3999 = select(0f, _e3971, (_e3971 > 0f));
let _e4001 = select(1e6f, _e3999, (_e3999 < 1e6f));
let _e4008 = select(0i, select(select(i32(_e4001), i32(-2147483648), (_e4001 < -2147483600f)), 2147483647i, (_e4001 > 2147483500f)), (_e4001 == _e4001));
let _e4012 = (_e4008 - select(0i, 1i, (_e4001 < f32(_e4008))));
let _e4014 = select(0f, _e3982, (_e3982 > 0f));
let _e4016 = select(1e6f, _e4014, (_e4014 < 1e6f));
let _e4023 = select(0i, select(select(i32(_e4016), i32(-2147483648), (_e4016 < -2147483600f)), 2147483647i, (_e4016 > 2147483500f)), (_e4016 == _e4016));
let _e4027 = (_e4023 - select(0i, 1i, (_e4016 < f32(_e4023))));
let _e4031 = (_e3971 - f32(_e4012));
let _e4033 = (_e3982 - f32(_e4027));
local_2 = (_e3960 - f32(_e3997));
let _e4034 = (_e3997 + 1i);
let _e4036 = select(_e4034, 0i, (_e4034 < 0i));
if (_e4036 >= _e3939) {
phi_6731_ = (_e3939 - 1i);
} else {
phi_6731_ = _e4036;
}
let _e4040 = phi_6731_;
local_3 = (_e4040 - _e3997);
let _e4042 = (_e4012 + 1i);
let _e4044 = select(_e4042, 0i, (_e4042 < 0i));
if (_e4044 >= _e3944) {
phi_6744_ = (_e3944 - 1i);
} else {
phi_6744_ = _e4044;
}
let _e4048 = phi_6744_;
let _e4050 = ((_e4048 - _e4012) * _e3939);
let _e4051 = (_e4027 + 1i);
let _e4053 = select(_e4051, 0i, (_e4051 < 0i));
if (_e4053 >= _e3949) {
phi_6758_ = (_e3949 - 1i);
} else {
phi_6758_ = _e4053;
}
let _e4057 = phi_6758_;
let _e4064 = global_1.member.member_13.member_10;
let _e4065 = bitcast<i32>(_e4064);
let _e4070 = ((_e4065 + (((_e4027 * _e3944) + _e4012) * _e3939)) + _e3997);
let _e4072 = select(_e1285, _e4070, (_e4070 < _e1285));
let _e4077 = global_8.member[bitcast<u32>(select(0i, _e4072, (_e4072 > 0i)))];
let _e4078 = local_2;
let _e4081 = local_3;
let _e4082 = (_e4070 + _e4081);
let _e4084 = select(_e1285, _e4082, (_e4082 < _e1285));
let _e4089 = global_8.member[bitcast<u32>(select(0i, _e4084, (_e4084 > 0i)))];
let _e4090 = local_2;
let _e4093 = (1f - _e4031);
let _e4095 = (_e4070 + _e4050);
let _e4097 = select(_e1285, _e4095, (_e4095 < _e1285));
let _e4102 = global_8.member[bitcast<u32>(select(0i, _e4097, (_e4097 > 0i)))];
let _e4103 = local_2;
let _e4106 = local_3;
let _e4107 = (_e4095 + _e4106);
let _e4109 = select(_e1285, _e4107, (_e4107 < _e1285));
let _e4114 = global_8.member[bitcast<u32>(select(0i, _e4109, (_e4109 > 0i)))];
let _e4115 = local_2;
let _e4120 = (_e4070 + (((_e4057 - _e4027) * _e3939) * _e3944));
let _e4122 = select(_e1285, _e4120, (_e4120 < _e1285));
let _e4127 = global_8.member[bitcast<u32>(select(0i, _e4122, (_e4122 > 0i)))];
let _e4128 = local_2;
let _e4131 = local_3;
let _e4132 = (_e4120 + _e4131);
let _e4134 = select(_e1285, _e4132, (_e4132 < _e1285));
let _e4139 = global_8.member[bitcast<u32>(select(0i, _e4134, (_e4134 > 0i)))];
let _e4140 = local_2;
let _e4144 = (_e4120 + _e4050);
let _e4146 = select(_e1285, _e4144, (_e4144 < _e1285));
let _e4151 = global_8.member[bitcast<u32>(select(0i, _e4146, (_e4146 > 0i)))];
let _e4152 = local_2;
let _e4155 = local_3;
let _e4156 = (_e4144 + _e4155);
let _e4158 = select(_e1285, _e4156, (_e4156 < _e1285));
let _e4163 = global_8.member[bitcast<u32>(select(0i, _e4158, (_e4158 > 0i)))];
let _e4164 = local_2;
let _e4173 = (_e3925 + _e3927);
let _e4183 = (((((_e781 + (_e464 * _e4173)) - _e3855.member) / _e3952) * _e3950) - 0.5f);
let _e4185 = select(0f, _e4183, (_e4183 > 0f));
let _e4187 = select(_e3956, _e4185, (_e4185 < _e3956));
let _e4191 = (((((_e782 + (_e475 * _e4173)) - _e3855.member_1) / _e3963) * _e3961) - 0.5f);
let _e4193 = select(0f, _e4191, (_e4191 > 0f));
let _e4195 = select(_e3967, _e4193, (_e4193 < _e3967));
let _e4199 = (((((_e783 + (_e486 * _e4173)) - _e3855.member_2) / _e3974) * _e3972) - 0.5f);
let _e4201 = select(0f, _e4199, (_e4199 > 0f));
let _e4203 = select(_e3978, _e4201, (_e4201 < _e3978));
let _e4205 = select(0f, _e4187, (_e4187 > 0f));
let _e4207 = select(1e6f, _e4205, (_e4205 < 1e6f));
let _e4214 = select(0i, select(select(i32(_e4207), i32(-2147483648), (_e4207 < -2147483600f)), 2147483647i, (_e4207 > 2147483500f)), (_e4207 == _e4207));
let _e4218 = (_e4214 - select(0i, 1i, (_e4207 < f32(_e4214))));
let _e4220 = select(0f, _e4195, (_e4195 > 0f));
let _e4222 = select(1e6f, _e4220, (_e4220 < 1e6f));
let _e4229 = select(0i, select(select(i32(_e4222), i32(-2147483648), (_e4222 < -2147483600f)), 2147483647i, (_e4222 > 2147483500f)), (_e4222 == _e4222));
let _e4233 = (_e4229 - select(0i, 1i, (_e4222 < f32(_e4229))));
let _e4235 = select(0f, _e4203, (_e4203 > 0f));
let _e4237 = select(1e6f, _e4235, (_e4235 < 1e6f));
let _e4244 = select(0i, select(select(i32(_e4237), i32(-2147483648), (_e4237 < -2147483600f)), 2147483647i, (_e4237 > 2147483500f)), (_e4237 == _e4237));
let _e4248 = (_e4244 - select(0i, 1i, (_e4237 < f32(_e4244))));
let _e4252 = (_e4195 - f32(_e4233));
let _e4254 = (_e4203 - f32(_e4248));
local = (_e4187 - f32(_e4218));
let _e4255 = (_e4218 + 1i);
let _e4257 = select(_e4255, 0i, (_e4255 < 0i));
if (_e4257 >= _e3939) {
phi_7074_ = (_e3939 - 1i);
} else {
phi_7074_ = _e4257;
}
let _e4261 = phi_7074_;
local_1 = (_e4261 - _e4218);
let _e4263 = (_e4233 + 1i);
let _e4265 = select(_e4263, 0i, (_e4263 < 0i));
if (_e4265 >= _e3944) {
phi_7087_ = (_e3944 - 1i);
} else {
phi_7087_ = _e4265;
}
let _e4269 = phi_7087_;
let _e4271 = ((_e4269 - _e4233) * _e3939);
let _e4272 = (_e4248 + 1i);
let _e4274 = select(_e4272, 0i, (_e4272 < 0i));
if (_e4274 >= _e3949) {
phi_7101_ = (_e3949 - 1i);
} else {
phi_7101_ = _e4274;
}
let _e4278 = phi_7101_;
let _e4286 = ((_e4065 + (((_e4248 * _e3944) + _e4233) * _e3939)) + _e4218);
let _e4288 = select(_e1285, _e4286, (_e4286 < _e1285));
let _e4293 = global_8.member[bitcast<u32>(select(0i, _e4288, (_e4288 > 0i)))];
let _e4294 = local;
let _e4297 = local_1;
let _e4298 = (_e4286 + _e4297);
let _e4300 = select(_e1285, _e4298, (_e4298 < _e1285));
let _e4305 = global_8.member[bitcast<u32>(select(0i, _e4300, (_e4300 > 0i)))];
let _e4306 = local;
let _e4309 = (1f - _e4252);
let _e4311 = (_e4286 + _e4271);
let _e4313 = select(_e1285, _e4311, (_e4311 < _e1285));
let _e4318 = global_8.member[bitcast<u32>(select(0i, _e4313, (_e4313 > 0i)))];
let _e4319 = local;
let _e4322 = local_1;
let _e4323 = (_e4311 + _e4322);
let _e4325 = select(_e1285, _e4323, (_e4323 < _e1285));
let _e4330 = global_8.member[bitcast<u32>(select(0i, _e4325, (_e4325 > 0i)))];
let _e4331 = local;
let _e4336 = (_e4286 + (((_e4278 - _e4248) * _e3939) * _e3944));
let _e4338 = select(_e1285, _e4336, (_e4336 < _e1285));
let _e4343 = global_8.member[bitcast<u32>(select(0i, _e4338, (_e4338 > 0i)))];
let _e4344 = local;
let _e4347 = local_1;
let _e4348 = (_e4336 + _e4347);
let _e4350 = select(_e1285, _e4348, (_e4348 < _e1285));
let _e4355 = global_8.member[bitcast<u32>(select(0i, _e4350, (_e4350 > 0i)))];
let _e4356 = local;
let _e4360 = (_e4336 + _e4271);
let _e4362 = select(_e1285, _e4360, (_e4360 < _e1285));
let _e4367 = global_8.member[bitcast<u32>(select(0i, _e4362, (_e4362 > 0i)))];
let _e4368 = local;
let _e4371 = local_1;
let _e4372 = (_e4360 + _e4371);
let _e4374 = select(_e1285, _e4372, (_e4372 < _e1285));
let _e4379 = global_8.member[bitcast<u32>(select(0i, _e4374, (_e4374 > 0i)))];
let _e4380 = local;
phi_6594_ = (_e3914 + 1u);
phi_6597_ = (_e3916 + ((0.5f * (((((((_e4077 * (1f - _e4078)) + (_e4089 * _e4090)) * _e4093) + (((_e4102 * (1f - _e4103)) + (_e4114 * _e4115)) * _e4031)) * (1f - _e4033)) + (((((_e4127 * (1f - _e4128)) + (_e4139 * _e4140)) * _e4093) + (((_e4151 * (1f - _e4152)) + (_e4163 * _e4164)) * _e4031)) * _e4033)) + ((((((_e4293 * (1f - _e4294)) + (_e4305 * _e4306)) * _e4309) + (((_e4318 * (1f - _e4319)) + (_e4330 * _e4331)) * _e4252)) * (1f - _e4254)) + (((((_e4343 * (1f - _e4344)) + (_e4355 * _e4356)) * _e4309) + (((_e4367 * (1f - _e4368)) + (_e4379 * _e4380)) * _e4252)) * _e4254)))) * _e3926));
} else {
phi_6594_ = u32();
phi_6597_ = f32();
}
let _e4395 = phi_6594_;
let _e4397 = phi_6597_;
continue;
continuing {
phi_6593_ = _e4395;
phi_6596_ = _e4397;
break if !(_e3919);
}
}
let _e4730 = local_40;
phi_7306_ = _e4730;
}
let _e4400 = phi_7306_;
let _e4404 = global_1.member.member_13.member;
let _e4409 = -((_e4404.member * _e4400));
let _e4411 = select(-87f, _e4409, (_e4409 > -87f));
let _e4413 = select(88f, _e4411, (_e4411 < 88f));
let _e4415 = ((_e4413 * 1.442695f) + 0.5f);
let _e4417 = select(-127f, _e4415, (_e4415 > -127f));
let _e4419 = select(128f, _e4417, (_e4417 < 128f));
let _e4426 = select(0i, select(select(i32(_e4419), i32(-2147483648), (_e4419 < -2147483600f)), 2147483647i, (_e4419 > 2147483500f)), (_e4419 == _e4419));
let _e4430 = (_e4426 - select(0i, 1i, (_e4419 < f32(_e4426))));
let _e4431 = f32(_e4430);
let _e4435 = ((_e4413 - (_e4431 * 0.6933594f)) - (_e4431 * -2.1219444e-4f));
let _e4457 = -((_e4404.member_1 * _e4400));
let _e4459 = select(-87f, _e4457, (_e4457 > -87f));
let _e4461 = select(88f, _e4459, (_e4459 < 88f));
let _e4463 = ((_e4461 * 1.442695f) + 0.5f);
let _e4465 = select(-127f, _e4463, (_e4463 > -127f));
let _e4467 = select(128f, _e4465, (_e4465 < 128f));
let _e4474 = select(0i, select(select(i32(_e4467), i32(-2147483648), (_e4467 < -2147483600f)), 2147483647i, (_e4467 > 2147483500f)), (_e4467 == _e4467));
let _e4478 = (_e4474 - select(0i, 1i, (_e4467 < f32(_e4474))));
let _e4479 = f32(_e4478);
let _e4483 = ((_e4461 - (_e4479 * 0.6933594f)) - (_e4479 * -2.1219444e-4f));
let _e4505 = -((_e4404.member_2 * _e4400));
let _e4507 = select(-87f, _e4505, (_e4505 > -87f));
let _e4509 = select(88f, _e4507, (_e4507 < 88f));
let _e4511 = ((_e4509 * 1.442695f) + 0.5f);
let _e4513 = select(-127f, _e4511, (_e4511 > -127f));
let _e4515 = select(128f, _e4513, (_e4513 < 128f));
let _e4522 = select(0i, select(select(i32(_e4515), i32(-2147483648), (_e4515 < -2147483600f)), 2147483647i, (_e4515 > 2147483500f)), (_e4515 == _e4515));
let _e4526 = (_e4522 - select(0i, 1i, (_e4515 < f32(_e4522))));
let _e4527 = f32(_e4526);
let _e4531 = ((_e4509 - (_e4527 * 0.6933594f)) - (_e4527 * -2.1219444e-4f));
let _e4554 = local_33;
let _e4559 = local_34;
let _e4564 = local_35;
phi_7542_ = array<f32, 19>(_e171, _e181, _e192, (_e203 + (((_e4554.x * _e1262.member_3.x) * ((1f + (_e4435 * (1f + (_e4435 * (0.5f + (_e4435 * (0.16666667f + (_e4435 * (0.041666668f + (_e4435 * (0.008333334f + (_e4435 * (0.001388889f + (_e4435 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4430 + 127i)) << bitcast<u32>(23i))))) * select(_e629, 1f, _e699))), (_e214 + (((_e4559.y * _e1262.member_3.y) * ((1f + (_e4483 * (1f + (_e4483 * (0.5f + (_e4483 * (0.16666667f + (_e4483 * (0.041666668f + (_e4483 * (0.008333334f + (_e4483 * (0.001388889f + (_e4483 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4478 + 127i)) << bitcast<u32>(23i))))) * select(_e640, 1f, _e699))), (_e225 + (((_e4564.z * _e1262.member_3.z) * ((1f + (_e4531 * (1f + (_e4531 * (0.5f + (_e4531 * (0.16666667f + (_e4531 * (0.041666668f + (_e4531 * (0.008333334f + (_e4531 * (0.001388889f + (_e4531 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4526 + 127i)) << bitcast<u32>(23i))))) * select(_e651, 1f, _e699))), _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357, _e368);
} else {
phi_7542_ = array<f32, 19>(_e171, _e181, _e192, _e203, _e214, _e225, _e236, _e247, _e258, _e269, _e280, _e291, _e302, _e313, _e324, _e335, _e346, _e357, _e368);
}
let _e4579 = phi_7542_;
global_5.member[_e160] = _e4579[0];
global_5.member[_e172] = _e4579[1];
global_5.member[_e183] = _e4579[2];
global_5.member[_e194] = _e4579[3];
global_5.member[_e205] = _e4579[4];
global_5.member[_e216] = _e4579[5];
global_5.member[_e227] = _e4579[6];
global_5.member[_e238] = _e4579[7];
global_5.member[_e249] = _e4579[8];
global_5.member[_e260] = _e4579[9];
global_5.member[_e271] = _e4579[10];
global_5.member[_e282] = _e4579[11];
global_5.member[_e293] = _e4579[12];
global_5.member[_e304] = _e4579[13];
global_5.member[_e315] = _e4579[14];
global_5.member[_e326] = _e4579[15];
global_5.member[_e337] = _e4579[16];
global_5.member[_e348] = _e4579[17];
global_5.member[_e359] = _e4579[18];
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
