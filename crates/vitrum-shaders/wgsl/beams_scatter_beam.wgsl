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
member: f32,
member_1: f32,
}
struct type_26 {
member: i32,
member_1: i32,
}
struct type_29 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_24;
@group(0) @binding(5)
var<storage> global_2: type_13;
@group(0) @binding(1)
var<storage> global_3: type_13;
@group(0) @binding(2)
var<storage> global_4: type_13;
@group(0) @binding(3)
var<storage> global_5: type_13;
@group(0) @binding(4)
var<storage> global_6: type_13;
@group(0) @binding(6)
var<storage> global_7: type_13;
@group(0) @binding(7)
var<storage, read_write> global_8: type_29;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: i32;
var local_17: i32;
var local_18: i32;
var local_19: i32;
var local_20: i32;
var local_21: i32;
var local_22: i32;
var local_23: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var local_32: i32;
var local_33: i32;
var local_34: i32;
var local_35: i32;
var local_36: i32;
var local_37: i32;
var local_38: i32;
var local_39: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var local_45: i32;
var local_46: i32;
var local_47: i32;
var local_48: i32;
var local_49: i32;
var local_50: i32;
var local_51: i32;
var local_52: i32;
var local_53: i32;
var local_54: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var local_59: i32;
var local_60: i32;
var local_61: i32;
var local_62: i32;
var local_63: i32;
var local_64: i32;
var local_65: i32;
var local_66: i32;
var local_67: i32;
var local_68: i32;
var local_69: i32;
var local_70: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var local_74: i32;
var local_75: i32;
var local_76: i32;
var local_77: i32;
var local_78: i32;
var local_79: i32;
var local_80: i32;
var local_81: i32;
var local_82: i32;
var local_83: i32;
var local_84: i32;
var local_85: i32;
var local_86: i32;
var local_87: i32;
var local_88: i32;
var local_89: i32;
var local_90: i32;
var local_91: i32;
var local_92: i32;
var local_93: i32;
var local_94: i32;
var local_95: i32;
var local_96: i32;
var local_97: i32;
var local_98: i32;
var local_99: i32;
var local_100: i32;
var local_101: i32;
var local_102: i32;
var local_103: i32;
var local_104: i32;
var local_105: i32;
var local_106: i32;
var local_107: i32;
var local_108: i32;
var local_109: i32;
var local_110: f32;
var local_111: i32;
var local_112: i32;
var local_113: i32;
var local_114: i32;
var local_115: i32;
var local_116: i32;
var local_117: i32;
var local_118: i32;
var local_119: i32;
var local_120: i32;
var local_121: i32;
var local_122: i32;
var local_123: i32;
var local_124: i32;
var local_125: i32;
var local_126: i32;
var local_127: i32;
var local_128: f32;
var local_129: i32;
var local_130: i32;
var local_131: i32;
var local_132: i32;
var local_133: i32;
var local_134: i32;
var local_135: i32;
var local_136: i32;
var local_137: i32;
var local_138: f32;
var local_139: i32;
var local_140: i32;
var local_141: i32;
var local_142: i32;
var local_143: i32;
var local_144: i32;
var local_145: i32;
var local_146: i32;
var local_147: i32;
var local_148: f32;
var local_149: i32;
var local_150: i32;
var local_151: i32;
var local_152: i32;
var local_153: i32;
var local_154: i32;
var local_155: i32;
var local_156: i32;
var local_157: i32;
var local_158: i32;
var local_159: i32;
var local_160: i32;
var local_161: i32;
var local_162: i32;
var local_163: i32;
var local_164: i32;
var local_165: i32;
var local_166: i32;
var local_167: i32;
var local_168: i32;
var local_169: i32;
var local_170: i32;
var local_171: i32;
var local_172: i32;
var local_173: i32;
var local_174: i32;
var local_175: i32;
var local_176: i32;
var local_177: i32;
var local_178: i32;
var local_179: i32;
var local_180: i32;
var local_181: i32;
var local_182: i32;
var local_183: i32;
var local_184: f32;
var local_185: i32;
var local_186: i32;
var local_187: i32;
var local_188: i32;
var local_189: i32;
var local_190: i32;
var local_191: i32;
var local_192: i32;
var local_193: i32;
var local_194: i32;
var local_195: i32;
var local_196: i32;
var local_197: i32;
var local_198: i32;
var local_199: i32;
var local_200: i32;
var local_201: i32;
var local_202: f32;
var local_203: i32;
var local_204: i32;
var local_205: i32;
var local_206: i32;
var local_207: i32;
var local_208: i32;
var local_209: i32;
var local_210: i32;
var local_211: i32;
var local_212: f32;
var local_213: i32;
var local_214: i32;
var local_215: i32;
var local_216: i32;
var local_217: i32;
var local_218: i32;
var local_219: i32;
var local_220: i32;
var local_221: i32;
var local_222: f32;
var local_223: i32;
var local_224: i32;
var local_225: i32;
var local_226: i32;
var local_227: i32;
var local_228: i32;
var local_229: i32;
var local_230: i32;
var local_231: i32;
var local_232: i32;
var local_233: i32;
var local_234: i32;
var local_235: i32;
var local_236: i32;
var local_237: i32;
var phi_865_: bool;
var phi_866_: bool;
var phi_867_: bool;
var phi_1247_: type_26;
var phi_1959_: f32;
var phi_1962_: u32;
var phi_1960_: f32;
var phi_1963_: u32;
var local_238: u32;
var phi_1992_: f32;
var phi_1995_: u32;
var phi_1993_: f32;
var phi_1996_: u32;
var phi_2007_: u32;
var phi_2062_: f32;
var phi_2065_: u32;
var phi_2063_: f32;
var phi_2066_: u32;
var local_239: u32;
var phi_2095_: f32;
var phi_2098_: u32;
var phi_2096_: f32;
var phi_2099_: u32;
var phi_2110_: u32;
var phi_2111_: u32;
var phi_2162_: f32;
var phi_2165_: u32;
var phi_2163_: f32;
var phi_2166_: u32;
var local_240: u32;
var phi_2195_: f32;
var phi_2198_: u32;
var phi_2196_: f32;
var phi_2199_: u32;
var phi_2210_: u32;
var phi_2211_: u32;
var phi_53290_: type_26;
var phi_53365_: i32;
var phi_75906_: type_26;
var phi_75981_: i32;
var phi_75985_: type_26;
var phi_75988_: i32;
var phi_76139_: type_26;
var phi_76142_: i32;
var phi_76272_: type_26;
var phi_76321_: u32;
var phi_76322_: u32;
var phi_76323_: u32;
var phi_76449_: i32;
var phi_76460_: i32;
var phi_76883_: f32;
var phi_77506_: type_26;
var phi_77703_: u32;
var phi_77704_: u32;
var phi_77705_: u32;
var phi_77739_: u32;
var phi_77769_: u32;
var phi_77799_: u32;
var phi_77836_: type_26;
var phi_76140_: type_26;
var phi_76143_: i32;
var phi_75986_: type_26;
var phi_75989_: i32;
var local_241: type_26;
var local_242: type_26;
var phi_77853_: i32;
var phi_85553_: i32;
var phi_85707_: i32;
var phi_85812_: type_26;
var phi_86239_: f32;
var phi_86865_: type_26;
var phi_86943_: i32;
var phi_86954_: i32;
var phi_86982_: type_26;
var phi_87031_: u32;
var phi_87032_: u32;
var phi_87033_: u32;
var phi_88017_: i32;
var phi_88028_: i32;
var phi_88056_: type_26;
var phi_88105_: u32;
var phi_88106_: u32;
var phi_88107_: u32;
var phi_89091_: i32;
var phi_89102_: i32;
var phi_89130_: type_26;
var phi_89179_: u32;
var phi_89180_: u32;
var phi_89181_: u32;
var phi_90165_: i32;
var phi_90176_: i32;
var phi_90204_: type_26;
var phi_90253_: u32;
var phi_90254_: u32;
var phi_90255_: u32;
var phi_91257_: type_26;
var phi_91335_: i32;
var phi_91346_: i32;
var phi_91374_: type_26;
var phi_91423_: u32;
var phi_91424_: u32;
var phi_91425_: u32;
var phi_92409_: i32;
var phi_92420_: i32;
var phi_92448_: type_26;
var phi_92497_: u32;
var phi_92498_: u32;
var phi_92499_: u32;
var phi_93483_: i32;
var phi_93494_: i32;
var phi_93522_: type_26;
var phi_93571_: u32;
var phi_93572_: u32;
var phi_93573_: u32;
var phi_94557_: i32;
var phi_94568_: i32;
var phi_94596_: type_26;
var phi_94645_: u32;
var phi_94646_: u32;
var phi_94647_: u32;
var phi_95649_: type_26;
var phi_95727_: i32;
var phi_95738_: i32;
var phi_95766_: type_26;
var phi_95815_: u32;
var phi_95816_: u32;
var phi_95817_: u32;
var phi_96801_: i32;
var phi_96812_: i32;
var phi_96840_: type_26;
var phi_96889_: u32;
var phi_96890_: u32;
var phi_96891_: u32;
var phi_97875_: i32;
var phi_97886_: i32;
var phi_97914_: type_26;
var phi_97963_: u32;
var phi_97964_: u32;
var phi_97965_: u32;
var phi_98949_: i32;
var phi_98960_: i32;
var phi_98988_: type_26;
var phi_99037_: u32;
var phi_99038_: u32;
var phi_99039_: u32;
var phi_100032_: type_26;
var phi_100265_: u32;
var phi_100295_: u32;
var phi_100325_: u32;
var phi_85708_: i32;
var phi_85554_: i32;
var phi_79518_: i32;
var phi_79672_: i32;
var phi_79777_: type_26;
var phi_80204_: f32;
var phi_80832_: type_26;
var phi_80910_: i32;
var phi_80921_: i32;
var phi_80949_: type_26;
var phi_80998_: u32;
var phi_80999_: u32;
var phi_81000_: u32;
var phi_81984_: i32;
var phi_81995_: i32;
var phi_82023_: type_26;
var phi_82072_: u32;
var phi_82073_: u32;
var phi_82074_: u32;
var phi_83058_: i32;
var phi_83069_: i32;
var phi_83097_: type_26;
var phi_83146_: u32;
var phi_83147_: u32;
var phi_83148_: u32;
var phi_84132_: i32;
var phi_84143_: i32;
var phi_84171_: type_26;
var phi_84220_: u32;
var phi_84221_: u32;
var phi_84222_: u32;
var phi_85215_: type_26;
var phi_85448_: u32;
var phi_85478_: u32;
var phi_85508_: u32;
var phi_79673_: i32;
var phi_79519_: i32;
var phi_77888_: i32;
var phi_78042_: i32;
var phi_78147_: type_26;
var phi_78574_: f32;
var phi_79176_: type_26;
var phi_79409_: u32;
var phi_79439_: u32;
var phi_79469_: u32;
var phi_78043_: i32;
var phi_77889_: i32;
var phi_61068_: i32;
var phi_61222_: i32;
var phi_61327_: type_26;
var phi_61754_: f32;
var phi_62380_: type_26;
var phi_62458_: i32;
var phi_62469_: i32;
var phi_62497_: type_26;
var phi_62546_: u32;
var phi_62547_: u32;
var phi_62548_: u32;
var phi_63532_: i32;
var phi_63543_: i32;
var phi_63571_: type_26;
var phi_63620_: u32;
var phi_63621_: u32;
var phi_63622_: u32;
var phi_64606_: i32;
var phi_64617_: i32;
var phi_64645_: type_26;
var phi_64694_: u32;
var phi_64695_: u32;
var phi_64696_: u32;
var phi_65680_: i32;
var phi_65691_: i32;
var phi_65719_: type_26;
var phi_65768_: u32;
var phi_65769_: u32;
var phi_65770_: u32;
var phi_66772_: type_26;
var phi_66850_: i32;
var phi_66861_: i32;
var phi_66889_: type_26;
var phi_66938_: u32;
var phi_66939_: u32;
var phi_66940_: u32;
var phi_67924_: i32;
var phi_67935_: i32;
var phi_67963_: type_26;
var phi_68012_: u32;
var phi_68013_: u32;
var phi_68014_: u32;
var phi_68998_: i32;
var phi_69009_: i32;
var phi_69037_: type_26;
var phi_69086_: u32;
var phi_69087_: u32;
var phi_69088_: u32;
var phi_70072_: i32;
var phi_70083_: i32;
var phi_70111_: type_26;
var phi_70160_: u32;
var phi_70161_: u32;
var phi_70162_: u32;
var phi_71164_: type_26;
var phi_71242_: i32;
var phi_71253_: i32;
var phi_71281_: type_26;
var phi_71330_: u32;
var phi_71331_: u32;
var phi_71332_: u32;
var phi_72316_: i32;
var phi_72327_: i32;
var phi_72355_: type_26;
var phi_72404_: u32;
var phi_72405_: u32;
var phi_72406_: u32;
var phi_73390_: i32;
var phi_73401_: i32;
var phi_73429_: type_26;
var phi_73478_: u32;
var phi_73479_: u32;
var phi_73480_: u32;
var phi_74464_: i32;
var phi_74475_: i32;
var phi_74503_: type_26;
var phi_74552_: u32;
var phi_74553_: u32;
var phi_74554_: u32;
var phi_75547_: type_26;
var phi_75780_: u32;
var phi_75810_: u32;
var phi_75840_: u32;
var phi_61223_: i32;
var phi_61069_: i32;
var phi_55033_: i32;
var phi_55187_: i32;
var phi_55292_: type_26;
var phi_55719_: f32;
var phi_56347_: type_26;
var phi_56425_: i32;
var phi_56436_: i32;
var phi_56464_: type_26;
var phi_56513_: u32;
var phi_56514_: u32;
var phi_56515_: u32;
var phi_57499_: i32;
var phi_57510_: i32;
var phi_57538_: type_26;
var phi_57587_: u32;
var phi_57588_: u32;
var phi_57589_: u32;
var phi_58573_: i32;
var phi_58584_: i32;
var phi_58612_: type_26;
var phi_58661_: u32;
var phi_58662_: u32;
var phi_58663_: u32;
var phi_59647_: i32;
var phi_59658_: i32;
var phi_59686_: type_26;
var phi_59735_: u32;
var phi_59736_: u32;
var phi_59737_: u32;
var phi_60730_: type_26;
var phi_60963_: u32;
var phi_60993_: u32;
var phi_61023_: u32;
var phi_55188_: i32;
var phi_55034_: i32;
var phi_53403_: i32;
var phi_53557_: i32;
var phi_53662_: type_26;
var phi_54089_: f32;
var phi_54691_: type_26;
var phi_54924_: u32;
var phi_54954_: u32;
var phi_54984_: u32;
var phi_53558_: i32;
var phi_53404_: i32;
var phi_4424_: type_26;
var phi_4499_: i32;
var phi_27796_: type_26;
var phi_27871_: i32;
var phi_27875_: type_26;
var phi_27878_: i32;
var phi_28029_: type_26;
var phi_28032_: i32;
var phi_28162_: type_26;
var phi_28211_: u32;
var phi_28212_: u32;
var phi_28213_: u32;
var phi_28339_: i32;
var phi_28350_: i32;
var phi_28773_: f32;
var phi_28905_: i32;
var phi_28918_: i32;
var phi_28932_: i32;
var phi_29236_: f32;
var phi_29363_: f32;
var phi_29648_: type_26;
var phi_29845_: u32;
var phi_29846_: u32;
var phi_29847_: u32;
var phi_29881_: u32;
var phi_29911_: u32;
var phi_29941_: u32;
var phi_29978_: type_26;
var phi_28030_: type_26;
var phi_28033_: i32;
var phi_27876_: type_26;
var phi_27879_: i32;
var local_243: type_26;
var local_244: type_26;
var phi_29995_: i32;
var phi_38199_: i32;
var phi_38353_: i32;
var phi_38458_: type_26;
var phi_38885_: f32;
var phi_39017_: i32;
var phi_39030_: i32;
var phi_39044_: i32;
var phi_39348_: f32;
var phi_39475_: f32;
var phi_39763_: type_26;
var phi_39841_: i32;
var phi_39852_: i32;
var phi_39880_: type_26;
var phi_39929_: u32;
var phi_39930_: u32;
var phi_39931_: u32;
var phi_40915_: i32;
var phi_40926_: i32;
var phi_40954_: type_26;
var phi_41003_: u32;
var phi_41004_: u32;
var phi_41005_: u32;
var phi_41989_: i32;
var phi_42000_: i32;
var phi_42028_: type_26;
var phi_42077_: u32;
var phi_42078_: u32;
var phi_42079_: u32;
var phi_43063_: i32;
var phi_43074_: i32;
var phi_43102_: type_26;
var phi_43151_: u32;
var phi_43152_: u32;
var phi_43153_: u32;
var phi_44155_: type_26;
var phi_44233_: i32;
var phi_44244_: i32;
var phi_44272_: type_26;
var phi_44321_: u32;
var phi_44322_: u32;
var phi_44323_: u32;
var phi_45307_: i32;
var phi_45318_: i32;
var phi_45346_: type_26;
var phi_45395_: u32;
var phi_45396_: u32;
var phi_45397_: u32;
var phi_46381_: i32;
var phi_46392_: i32;
var phi_46420_: type_26;
var phi_46469_: u32;
var phi_46470_: u32;
var phi_46471_: u32;
var phi_47455_: i32;
var phi_47466_: i32;
var phi_47494_: type_26;
var phi_47543_: u32;
var phi_47544_: u32;
var phi_47545_: u32;
var phi_48547_: type_26;
var phi_48625_: i32;
var phi_48636_: i32;
var phi_48664_: type_26;
var phi_48713_: u32;
var phi_48714_: u32;
var phi_48715_: u32;
var phi_49699_: i32;
var phi_49710_: i32;
var phi_49738_: type_26;
var phi_49787_: u32;
var phi_49788_: u32;
var phi_49789_: u32;
var phi_50773_: i32;
var phi_50784_: i32;
var phi_50812_: type_26;
var phi_50861_: u32;
var phi_50862_: u32;
var phi_50863_: u32;
var phi_51847_: i32;
var phi_51858_: i32;
var phi_51886_: type_26;
var phi_51935_: u32;
var phi_51936_: u32;
var phi_51937_: u32;
var phi_52930_: type_26;
var phi_53163_: u32;
var phi_53193_: u32;
var phi_53223_: u32;
var phi_38354_: i32;
var phi_38200_: i32;
var phi_31912_: i32;
var phi_32066_: i32;
var phi_32171_: type_26;
var phi_32598_: f32;
var phi_32730_: i32;
var phi_32743_: i32;
var phi_32757_: i32;
var phi_33061_: f32;
var phi_33188_: f32;
var phi_33478_: type_26;
var phi_33556_: i32;
var phi_33567_: i32;
var phi_33595_: type_26;
var phi_33644_: u32;
var phi_33645_: u32;
var phi_33646_: u32;
var phi_34630_: i32;
var phi_34641_: i32;
var phi_34669_: type_26;
var phi_34718_: u32;
var phi_34719_: u32;
var phi_34720_: u32;
var phi_35704_: i32;
var phi_35715_: i32;
var phi_35743_: type_26;
var phi_35792_: u32;
var phi_35793_: u32;
var phi_35794_: u32;
var phi_36778_: i32;
var phi_36789_: i32;
var phi_36817_: type_26;
var phi_36866_: u32;
var phi_36867_: u32;
var phi_36868_: u32;
var phi_37861_: type_26;
var phi_38094_: u32;
var phi_38124_: u32;
var phi_38154_: u32;
var phi_32067_: i32;
var phi_31913_: i32;
var phi_30030_: i32;
var phi_30184_: i32;
var phi_30289_: type_26;
var phi_30716_: f32;
var phi_30848_: i32;
var phi_30861_: i32;
var phi_30875_: i32;
var phi_31179_: f32;
var phi_31306_: f32;
var phi_31570_: type_26;
var phi_31803_: u32;
var phi_31833_: u32;
var phi_31863_: u32;
var phi_30185_: i32;
var phi_30031_: i32;
var phi_12706_: i32;
var phi_12860_: i32;
var phi_12965_: type_26;
var phi_13392_: f32;
var phi_13524_: i32;
var phi_13537_: i32;
var phi_13551_: i32;
var phi_13855_: f32;
var phi_13982_: f32;
var phi_14270_: type_26;
var phi_14348_: i32;
var phi_14359_: i32;
var phi_14387_: type_26;
var phi_14436_: u32;
var phi_14437_: u32;
var phi_14438_: u32;
var phi_15422_: i32;
var phi_15433_: i32;
var phi_15461_: type_26;
var phi_15510_: u32;
var phi_15511_: u32;
var phi_15512_: u32;
var phi_16496_: i32;
var phi_16507_: i32;
var phi_16535_: type_26;
var phi_16584_: u32;
var phi_16585_: u32;
var phi_16586_: u32;
var phi_17570_: i32;
var phi_17581_: i32;
var phi_17609_: type_26;
var phi_17658_: u32;
var phi_17659_: u32;
var phi_17660_: u32;
var phi_18662_: type_26;
var phi_18740_: i32;
var phi_18751_: i32;
var phi_18779_: type_26;
var phi_18828_: u32;
var phi_18829_: u32;
var phi_18830_: u32;
var phi_19814_: i32;
var phi_19825_: i32;
var phi_19853_: type_26;
var phi_19902_: u32;
var phi_19903_: u32;
var phi_19904_: u32;
var phi_20888_: i32;
var phi_20899_: i32;
var phi_20927_: type_26;
var phi_20976_: u32;
var phi_20977_: u32;
var phi_20978_: u32;
var phi_21962_: i32;
var phi_21973_: i32;
var phi_22001_: type_26;
var phi_22050_: u32;
var phi_22051_: u32;
var phi_22052_: u32;
var phi_23054_: type_26;
var phi_23132_: i32;
var phi_23143_: i32;
var phi_23171_: type_26;
var phi_23220_: u32;
var phi_23221_: u32;
var phi_23222_: u32;
var phi_24206_: i32;
var phi_24217_: i32;
var phi_24245_: type_26;
var phi_24294_: u32;
var phi_24295_: u32;
var phi_24296_: u32;
var phi_25280_: i32;
var phi_25291_: i32;
var phi_25319_: type_26;
var phi_25368_: u32;
var phi_25369_: u32;
var phi_25370_: u32;
var phi_26354_: i32;
var phi_26365_: i32;
var phi_26393_: type_26;
var phi_26442_: u32;
var phi_26443_: u32;
var phi_26444_: u32;
var phi_27437_: type_26;
var phi_27670_: u32;
var phi_27700_: u32;
var phi_27730_: u32;
var phi_12861_: i32;
var phi_12707_: i32;
var phi_6419_: i32;
var phi_6573_: i32;
var phi_6678_: type_26;
var phi_7105_: f32;
var phi_7237_: i32;
var phi_7250_: i32;
var phi_7264_: i32;
var phi_7568_: f32;
var phi_7695_: f32;
var phi_7985_: type_26;
var phi_8063_: i32;
var phi_8074_: i32;
var phi_8102_: type_26;
var phi_8151_: u32;
var phi_8152_: u32;
var phi_8153_: u32;
var phi_9137_: i32;
var phi_9148_: i32;
var phi_9176_: type_26;
var phi_9225_: u32;
var phi_9226_: u32;
var phi_9227_: u32;
var phi_10211_: i32;
var phi_10222_: i32;
var phi_10250_: type_26;
var phi_10299_: u32;
var phi_10300_: u32;
var phi_10301_: u32;
var phi_11285_: i32;
var phi_11296_: i32;
var phi_11324_: type_26;
var phi_11373_: u32;
var phi_11374_: u32;
var phi_11375_: u32;
var phi_12368_: type_26;
var phi_12601_: u32;
var phi_12631_: u32;
var phi_12661_: u32;
var phi_6574_: i32;
var phi_6420_: i32;
var phi_4537_: i32;
var phi_4691_: i32;
var phi_4796_: type_26;
var phi_5223_: f32;
var phi_5355_: i32;
var phi_5368_: i32;
var phi_5382_: i32;
var phi_5686_: f32;
var phi_5813_: f32;
var phi_6077_: type_26;
var phi_6310_: u32;
var phi_6340_: u32;
var phi_6370_: u32;
var phi_4692_: i32;
var phi_4538_: i32;
var phi_2256_: type_26;
var phi_2331_: i32;
var phi_2338_: i32;
var phi_2492_: i32;
var phi_2597_: type_26;
var phi_3030_: f32;
var phi_3162_: i32;
var phi_3175_: i32;
var phi_3189_: i32;
var phi_3390_: f32;
var phi_3433_: vec3<f32>;
var phi_3436_: i32;
var phi_3642_: f32;
var phi_3769_: f32;
var phi_3799_: type_25;
var phi_3434_: vec3<f32>;
var phi_3437_: i32;
var local_245: vec3<f32>;
var local_246: vec3<f32>;
var local_247: vec3<f32>;
var phi_4060_: type_26;
var phi_4293_: u32;
var phi_4323_: u32;
var phi_4353_: u32;
var phi_2493_: i32;
var phi_2339_: i32;
var local_248: u32;
var local_249: u32;
var local_250: u32;
var local_251: u32;
var local_252: u32;
var local_253: u32;
var local_254: type_26;
var local_255: type_26;
let _e267 = global;
let _e277 = arrayLength((&global_5.member));
let _e280 = arrayLength((&global_6.member));
let _e283 = arrayLength((&global_2.member));
let _e286 = arrayLength((&global_7.member));
let _e288 = arrayLength((&global_8.member));
let _e291 = global_1.member.member;
if (_e267.x < _e291.member) {
if (_e267.y < _e291.member_1) {
let _e299 = bitcast<i32>(_e267.x);
let _e303 = global_1.member.member.member;
let _e304 = bitcast<i32>(_e303);
let _e308 = global_1.member.member_12.member_4;
let _e312 = global_1.member.member_12.member_7;
let _e314 = bitcast<i32>((_e308 * _e312));
let _e316 = bitcast<i32>((_e267.y * 16u));
local_235 = _e314;
local_236 = _e299;
local_237 = _e304;
let _e317 = local_235;
let _e318 = local_237;
let _e321 = local_236;
let _e322 = ((_e317 + (11i * _e318)) + _e321);
let _e324 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e326 = select(_e324, _e322, (_e322 < _e324));
let _e331 = global_4.member[bitcast<u32>(select(0i, _e326, (_e326 > 0i)))];
let _e332 = f32(_e316);
if (_e331 < _e332) {
phi_866_ = bool();
phi_867_ = true;
} else {
let _e334 = local_235;
let _e335 = local_237;
let _e338 = local_236;
let _e339 = ((_e334 + (10i * _e335)) + _e338);
let _e341 = select(_e324, _e339, (_e339 < _e324));
let _e346 = global_4.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
let _e349 = (_e346 > f32((_e316 + 15i)));
if _e349 {
phi_865_ = bool();
} else {
let _e350 = local_235;
let _e351 = local_237;
let _e354 = local_236;
let _e355 = ((_e350 + (11i * _e351)) + _e354);
let _e357 = select(_e324, _e355, (_e355 < _e324));
let _e362 = global_4.member[bitcast<u32>(select(0i, _e357, (_e357 > 0i)))];
phi_865_ = (_e346 <= _e362);
}
let _e365 = phi_865_;
phi_866_ = _e365;
phi_867_ = _e349;
}
let _e367 = phi_866_;
let _e369 = phi_867_;
if select(_e367, false, _e369) {
local_232 = _e314;
local_233 = _e299;
local_234 = _e304;
let _e371 = local_232;
let _e372 = local_234;
let _e375 = local_233;
let _e376 = ((_e371 + (10i * _e372)) + _e375);
let _e378 = select(_e324, _e376, (_e376 < _e324));
let _e383 = global_4.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e384 = local_232;
let _e385 = local_234;
let _e388 = local_233;
let _e389 = ((_e384 + (11i * _e385)) + _e388);
let _e391 = select(_e324, _e389, (_e389 < _e324));
let _e396 = global_4.member[bitcast<u32>(select(0i, _e391, (_e391 > 0i)))];
let _e397 = local_232;
let _e398 = local_234;
let _e401 = local_233;
let _e402 = ((_e397 + (12i * _e398)) + _e401);
let _e404 = select(_e324, _e402, (_e402 < _e324));
let _e409 = global_4.member[bitcast<u32>(select(0i, _e404, (_e404 > 0i)))];
let _e410 = local_232;
let _e411 = local_234;
let _e414 = local_233;
let _e415 = ((_e410 + (13i * _e411)) + _e414);
let _e417 = select(_e324, _e415, (_e415 < _e324));
let _e422 = global_4.member[bitcast<u32>(select(0i, _e417, (_e417 > 0i)))];
local_229 = _e314;
local_230 = _e299;
local_231 = _e304;
let _e423 = local_229;
let _e424 = local_231;
let _e426 = local_230;
let _e427 = ((_e423 + _e424) + _e426);
let _e429 = select(_e324, _e427, (_e427 < _e324));
let _e434 = global_4.member[bitcast<u32>(select(0i, _e429, (_e429 > 0i)))];
let _e435 = local_229;
let _e436 = local_231;
let _e439 = local_230;
let _e440 = ((_e435 + (2i * _e436)) + _e439);
let _e442 = select(_e324, _e440, (_e440 < _e324));
let _e447 = global_4.member[bitcast<u32>(select(0i, _e442, (_e442 > 0i)))];
let _e448 = local_229;
let _e449 = local_231;
let _e452 = local_230;
let _e453 = ((_e448 + (3i * _e449)) + _e452);
let _e455 = select(_e324, _e453, (_e453 < _e324));
let _e460 = global_4.member[bitcast<u32>(select(0i, _e455, (_e455 > 0i)))];
let _e461 = local_229;
let _e462 = local_230;
let _e463 = (_e461 + _e462);
let _e465 = select(_e324, _e463, (_e463 < _e324));
let _e470 = global_4.member[bitcast<u32>(select(0i, _e465, (_e465 > 0i)))];
let _e471 = (_e470 > 0f);
let _e472 = local_229;
let _e473 = local_231;
let _e476 = local_230;
let _e477 = ((_e472 + (4i * _e473)) + _e476);
let _e479 = select(_e324, _e477, (_e477 < _e324));
let _e484 = global_4.member[bitcast<u32>(select(0i, _e479, (_e479 > 0i)))];
let _e485 = local_229;
let _e486 = local_231;
let _e489 = local_230;
let _e490 = ((_e485 + (5i * _e486)) + _e489);
let _e492 = select(_e324, _e490, (_e490 < _e324));
let _e497 = global_4.member[bitcast<u32>(select(0i, _e492, (_e492 > 0i)))];
let _e498 = local_229;
let _e499 = local_231;
let _e502 = local_230;
let _e503 = ((_e498 + (6i * _e499)) + _e502);
let _e505 = select(_e324, _e503, (_e503 < _e324));
let _e510 = global_4.member[bitcast<u32>(select(0i, _e505, (_e505 > 0i)))];
let _e511 = local_229;
let _e512 = local_231;
let _e515 = local_230;
let _e516 = ((_e511 + (7i * _e512)) + _e515);
let _e518 = select(_e324, _e516, (_e516 < _e324));
let _e523 = global_4.member[bitcast<u32>(select(0i, _e518, (_e518 > 0i)))];
let _e524 = local_229;
let _e525 = local_231;
let _e528 = local_230;
let _e529 = ((_e524 + (8i * _e525)) + _e528);
let _e531 = select(_e324, _e529, (_e529 < _e324));
let _e536 = global_4.member[bitcast<u32>(select(0i, _e531, (_e531 > 0i)))];
let _e537 = local_229;
let _e538 = local_231;
let _e541 = local_230;
let _e542 = ((_e537 + (9i * _e538)) + _e541);
let _e544 = select(_e324, _e542, (_e542 < _e324));
let _e549 = global_4.member[bitcast<u32>(select(0i, _e544, (_e544 > 0i)))];
let _e552 = bitcast<f32>((bitcast<u32>(_e447) & 2147483647u));
let _e556 = global_1.member.member_1.member;
let _e560 = global_1.member.member_1.member_1;
let _e561 = bitcast<i32>(_e556);
let _e562 = bitcast<i32>(_e560);
if _e471 {
phi_1247_ = type_26(_e562, _e561);
} else {
phi_1247_ = type_26(_e561, _e562);
}
let _e566 = phi_1247_;
let _e571 = global_1.member.member_12.member_10;
if ((_e471 != (_e571 == 1u)) || (_e316 >= _e566.member)) {
} else {
let _e579 = global_1.member.member_12.member_6;
local_226 = bitcast<i32>((_e308 * _e579));
local_227 = _e299;
local_228 = _e304;
let _e582 = local_226;
let _e583 = local_227;
let _e584 = (_e582 + _e583);
let _e586 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e588 = select(_e586, _e584, (_e584 < _e586));
let _e593 = global_3.member[bitcast<u32>(select(0i, _e588, (_e588 > 0i)))];
let _e594 = local_226;
let _e595 = local_228;
let _e597 = local_227;
let _e598 = ((_e594 + _e595) + _e597);
let _e600 = select(_e586, _e598, (_e598 < _e586));
let _e605 = global_3.member[bitcast<u32>(select(0i, _e600, (_e600 > 0i)))];
let _e606 = local_226;
let _e607 = local_228;
let _e610 = local_227;
let _e611 = ((_e606 + (2i * _e607)) + _e610);
let _e613 = select(_e586, _e611, (_e611 < _e586));
let _e618 = global_3.member[bitcast<u32>(select(0i, _e613, (_e613 > 0i)))];
let _e619 = local_226;
let _e620 = local_228;
let _e623 = local_227;
let _e624 = ((_e619 + (3i * _e620)) + _e623);
let _e626 = select(_e586, _e624, (_e624 < _e586));
let _e631 = global_3.member[bitcast<u32>(select(0i, _e626, (_e626 > 0i)))];
let _e632 = local_226;
let _e633 = local_228;
let _e636 = local_227;
let _e637 = ((_e632 + (4i * _e633)) + _e636);
let _e639 = select(_e586, _e637, (_e637 < _e586));
let _e644 = global_3.member[bitcast<u32>(select(0i, _e639, (_e639 > 0i)))];
let _e645 = local_226;
let _e646 = local_228;
let _e649 = local_227;
let _e650 = ((_e645 + (5i * _e646)) + _e649);
let _e652 = select(_e586, _e650, (_e650 < _e586));
let _e657 = global_3.member[bitcast<u32>(select(0i, _e652, (_e652 > 0i)))];
let _e658 = local_226;
let _e659 = local_228;
let _e662 = local_227;
let _e663 = ((_e658 + (18i * _e659)) + _e662);
let _e665 = select(_e586, _e663, (_e663 < _e586));
let _e670 = global_3.member[bitcast<u32>(select(0i, _e665, (_e665 > 0i)))];
let _e671 = local_226;
let _e672 = local_228;
let _e675 = local_227;
let _e676 = ((_e671 + (19i * _e672)) + _e675);
let _e678 = select(_e586, _e676, (_e676 < _e586));
let _e683 = global_3.member[bitcast<u32>(select(0i, _e678, (_e678 > 0i)))];
let _e684 = local_226;
let _e685 = local_228;
let _e688 = local_227;
let _e689 = ((_e684 + (20i * _e685)) + _e688);
let _e691 = select(_e586, _e689, (_e689 < _e586));
let _e696 = global_3.member[bitcast<u32>(select(0i, _e691, (_e691 > 0i)))];
let _e697 = local_226;
let _e698 = local_228;
let _e701 = local_227;
let _e702 = ((_e697 + (23i * _e698)) + _e701);
let _e704 = select(_e586, _e702, (_e702 < _e586));
let _e709 = global_3.member[bitcast<u32>(select(0i, _e704, (_e704 > 0i)))];
let _e710 = (_e316 + 16i);
let _e712 = (0.5f * (16f - 1f));
let _e713 = (_e332 + _e712);
let _e717 = (-(((_e434 * _e713) + _e460)) / _e447);
let _e735 = (0.5f * 1f);
let _e737 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e484 * _e713) + ((_e497 * _e717) + _e510))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e523 * _e713) + ((_e536 * _e717) + _e549))) & 2147483647u)))) / _e552) + _e735));
let _e741 = global_1.member.member_18.member_1;
phi_1959_ = 8f;
phi_1962_ = 0u;
loop {
let _e743 = phi_1959_;
let _e745 = phi_1962_;
local_238 = _e745;
local_248 = _e745;
let _e748 = ((_e745 < _e741) && (_e737 >= _e743));
if _e748 {
phi_1960_ = (_e743 * 2f);
phi_1963_ = (_e745 + 1u);
} else {
phi_1960_ = f32();
phi_1963_ = u32();
}
let _e752 = phi_1960_;
let _e754 = phi_1963_;
continue;
continuing {
phi_1959_ = _e752;
phi_1962_ = _e754;
break if !(_e748);
}
}
let _e757 = local_238;
let _e761 = f32((1i << bitcast<u32>((_e757 & 31u))));
let _e764 = f32(_e710);
if (((_e332 - _e761) > _e409) && ((_e764 + _e761) < _e422)) {
let _e27129 = local_248;
phi_2007_ = _e27129;
} else {
phi_1992_ = 8f;
phi_1995_ = 0u;
loop {
let _e770 = phi_1992_;
let _e772 = phi_1995_;
local_249 = _e772;
let _e775 = ((_e772 < _e741) && ((_e737 * 0.125f) >= _e770));
if _e775 {
phi_1993_ = (_e770 * 2f);
phi_1996_ = (_e772 + 1u);
} else {
phi_1993_ = f32();
phi_1996_ = u32();
}
let _e779 = phi_1993_;
let _e781 = phi_1996_;
continue;
continuing {
phi_1992_ = _e779;
phi_1995_ = _e781;
break if !(_e775);
}
}
let _e27131 = local_249;
phi_2007_ = _e27131;
}
let _e784 = phi_2007_;
let _e785 = (_e316 - 16i);
let _e787 = (_e383 <= _e396);
let _e788 = f32(_e785);
if ((_e785 >= 0i) && ((_e787 && (_e396 >= _e788)) && (_e383 <= f32((_e316 - 1i))))) {
let _e796 = (_e788 + _e712);
let _e800 = (-(((_e434 * _e796) + _e460)) / _e447);
let _e819 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e484 * _e796) + ((_e497 * _e800) + _e510))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e523 * _e796) + ((_e536 * _e800) + _e549))) & 2147483647u)))) / _e552) + _e735));
phi_2062_ = 8f;
phi_2065_ = 0u;
loop {
let _e821 = phi_2062_;
let _e823 = phi_2065_;
local_239 = _e823;
local_250 = _e823;
let _e826 = ((_e823 < _e741) && (_e819 >= _e821));
if _e826 {
phi_2063_ = (_e821 * 2f);
phi_2066_ = (_e823 + 1u);
} else {
phi_2063_ = f32();
phi_2066_ = u32();
}
let _e830 = phi_2063_;
let _e832 = phi_2066_;
continue;
continuing {
phi_2062_ = _e830;
phi_2065_ = _e832;
break if !(_e826);
}
}
let _e835 = local_239;
let _e839 = f32((1i << bitcast<u32>((_e835 & 31u))));
if (((_e788 - _e839) > _e409) && ((_e332 + _e839) < _e422)) {
let _e27143 = local_250;
phi_2110_ = _e27143;
} else {
phi_2095_ = 8f;
phi_2098_ = 0u;
loop {
let _e847 = phi_2095_;
let _e849 = phi_2098_;
local_251 = _e849;
let _e852 = ((_e849 < _e741) && ((_e819 * 0.125f) >= _e847));
if _e852 {
phi_2096_ = (_e847 * 2f);
phi_2099_ = (_e849 + 1u);
} else {
phi_2096_ = f32();
phi_2099_ = u32();
}
let _e856 = phi_2096_;
let _e858 = phi_2099_;
continue;
continuing {
phi_2095_ = _e856;
phi_2098_ = _e858;
break if !(_e852);
}
}
let _e27145 = local_251;
phi_2110_ = _e27145;
}
let _e861 = phi_2110_;
phi_2111_ = _e861;
} else {
phi_2111_ = _e784;
}
let _e863 = phi_2111_;
if ((_e710 < _e566.member) && ((_e787 && (_e396 >= _e764)) && (_e383 <= f32((_e316 + 31i))))) {
let _e873 = (_e764 + _e712);
let _e877 = (-(((_e434 * _e873) + _e460)) / _e447);
let _e896 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e484 * _e873) + ((_e497 * _e877) + _e510))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e523 * _e873) + ((_e536 * _e877) + _e549))) & 2147483647u)))) / _e552) + _e735));
phi_2162_ = 8f;
phi_2165_ = 0u;
loop {
let _e898 = phi_2162_;
let _e900 = phi_2165_;
local_240 = _e900;
local_252 = _e900;
let _e903 = ((_e900 < _e741) && (_e896 >= _e898));
if _e903 {
phi_2163_ = (_e898 * 2f);
phi_2166_ = (_e900 + 1u);
} else {
phi_2163_ = f32();
phi_2166_ = u32();
}
let _e907 = phi_2163_;
let _e909 = phi_2166_;
continue;
continuing {
phi_2162_ = _e907;
phi_2165_ = _e909;
break if !(_e903);
}
}
let _e912 = local_240;
let _e916 = f32((1i << bitcast<u32>((_e912 & 31u))));
if (((_e764 - _e916) > _e409) && ((f32((_e316 + 32i)) + _e916) < _e422)) {
let _e27158 = local_252;
phi_2210_ = _e27158;
} else {
phi_2195_ = 8f;
phi_2198_ = 0u;
loop {
let _e925 = phi_2195_;
let _e927 = phi_2198_;
local_253 = _e927;
let _e930 = ((_e927 < _e741) && ((_e896 * 0.125f) >= _e925));
if _e930 {
phi_2196_ = (_e925 * 2f);
phi_2199_ = (_e927 + 1u);
} else {
phi_2196_ = f32();
phi_2199_ = u32();
}
let _e934 = phi_2196_;
let _e936 = phi_2199_;
continue;
continuing {
phi_2195_ = _e934;
phi_2198_ = _e936;
break if !(_e930);
}
}
let _e27160 = local_253;
phi_2210_ = _e27160;
}
let _e939 = phi_2210_;
phi_2211_ = _e939;
} else {
phi_2211_ = _e784;
}
let _e941 = phi_2211_;
if (_e291.member_2 == 2u) {
let _e25757 = global_1.member.member_1.member;
let _e25760 = global_1.member.member_1.member_1;
let _e25761 = bitcast<i32>(_e25757);
let _e25762 = bitcast<i32>(_e25760);
if _e471 {
phi_2256_ = type_26(_e25762, _e25761);
} else {
phi_2256_ = type_26(_e25761, _e25762);
}
let _e25766 = phi_2256_;
let _e25770 = f32((_e316 + 15i));
let _e25772 = select(_e25770, _e396, (_e396 < _e25770));
let _e25774 = select(_e332, _e25772, (_e25772 > _e332));
let _e25776 = select(_e25770, _e25774, (_e25774 < _e25770));
let _e25783 = select(0i, select(select(i32(_e25776), i32(-2147483648), (_e25776 < -2147483600f)), 2147483647i, (_e25776 > 2147483500f)), (_e25776 == _e25776));
let _e25788 = bitcast<i32>((_e25783 - select(0i, 1i, (_e25776 < f32(_e25783)))));
let _e25790 = select(_e332, _e383, (_e383 > _e332));
let _e25792 = select(_e332, _e25790, (_e25790 > _e332));
let _e25794 = select(_e25770, _e25792, (_e25792 < _e25770));
let _e25801 = select(0i, select(select(i32(_e25794), i32(-2147483648), (_e25794 < -2147483600f)), 2147483647i, (_e25794 > 2147483500f)), (_e25794 == _e25794));
if (_e25788 < _e25766.member) {
phi_2331_ = _e25788;
} else {
phi_2331_ = (_e25766.member - 1i);
}
let _e25810 = phi_2331_;
phi_2338_ = 0i;
loop {
let _e25813 = phi_2338_;
let _e25814 = (_e25813 < 16i);
if _e25814 {
let _e25816 = (bitcast<i32>((_e25801 - select(0i, 1i, (_e25794 < f32(_e25801))))) + (_e25813 & 15i));
let _e25820 = (((f32(_e25816) + 0.5f) * 1f) - 0.5f);
let _e25824 = (-(((_e434 * _e25820) + _e460)) / _e447);
let _e25831 = bitcast<f32>((bitcast<u32>(((_e484 * _e25820) + ((_e497 * _e25824) + _e510))) & 2147483647u));
let _e25838 = bitcast<f32>((bitcast<u32>(((_e523 * _e25820) + ((_e536 * _e25824) + _e549))) & 2147483647u));
let _e25842 = (((0.5f * (_e25831 + _e25838)) / _e552) + _e735);
let _e25843 = (1f / 1f);
let _e25851 = ((((_e25824 + _e25842) + 0.5f) * _e25843) - 0.5f);
let _e25852 = f32((_e25766.member_1 - 1i));
let _e25853 = (0f - 1f);
let _e25855 = select(_e25853, _e25851, (_e25851 > _e25853));
let _e25857 = select(_e25852, _e25855, (_e25855 < _e25852));
let _e25864 = select(0i, select(select(i32(_e25857), i32(-2147483648), (_e25857 < -2147483600f)), 2147483647i, (_e25857 > 2147483500f)), (_e25857 == _e25857));
let _e25869 = (((((_e25824 - _e25842) + 0.5f) * _e25843) - 0.5f) + 1f);
let _e25870 = (_e25852 + 1f);
let _e25872 = select(0f, _e25869, (_e25869 > 0f));
let _e25874 = select(_e25870, _e25872, (_e25872 < _e25870));
let _e25881 = select(0i, select(select(i32(_e25874), i32(-2147483648), (_e25874 < -2147483600f)), 2147483647i, (_e25874 > 2147483500f)), (_e25874 == _e25874));
let _e25892 = ((1e-4f * 1f) * _e552);
let _e25894 = select(_e25838, _e25831, (_e25831 > _e25838));
let _e25896 = select(_e25892, _e25894, (_e25894 > _e25892));
let _e25898 = select(_e25838, _e25831, (_e25831 < _e25838));
let _e25900 = select(_e25892, _e25898, (_e25898 > _e25892));
let _e25902 = (0.5f * (_e25896 + _e25900));
let _e25903 = (0.5f / _e25900);
let _e25904 = (1f / _e25896);
phi_2492_ = 0i;
loop {
let _e25906 = phi_2492_;
let _e25908 = (((_e25881 - select(0i, 1i, (_e25874 < f32(_e25881)))) + (_e25813 >> bitcast<u32>(4u))) + bitcast<i32>(_e25906));
let _e25909 = (_e25908 <= select(-1i, (_e25864 - select(0i, 1i, (_e25857 < f32(_e25864)))), (_e25816 <= _e25810)));
if _e25909 {
let _e25915 = (((((f32(_e25908) + 0.5f) * 1f) - 0.5f) - _e25824) * _e552);
let _e25916 = (_e552 * 1f);
let _e25918 = (0.5f * _e25916);
let _e25919 = (_e25915 + _e25918);
let _e25920 = -(_e25919);
let _e25923 = (_e25902 - select(_e25920, _e25919, (_e25919 > _e25920)));
let _e25925 = select(0f, _e25923, (_e25923 > 0f));
let _e25927 = select(_e25900, _e25925, (_e25925 < _e25900));
let _e25930 = (_e25923 - _e25900);
let _e25934 = (((_e25927 * (_e25927 * _e25903)) + select(0f, _e25930, (_e25930 > 0f))) * _e25904);
let _e25938 = (_e25915 - _e25918);
let _e25939 = -(_e25938);
let _e25942 = (_e25902 - select(_e25939, _e25938, (_e25938 > _e25939)));
let _e25944 = select(0f, _e25942, (_e25942 > 0f));
let _e25946 = select(_e25900, _e25944, (_e25944 < _e25900));
let _e25949 = (_e25942 - _e25900);
let _e25953 = (((_e25946 * (_e25946 * _e25903)) + select(0f, _e25949, (_e25949 > 0f))) * _e25904);
if _e471 {
phi_2597_ = type_26(_e25908, _e25816);
} else {
phi_2597_ = type_26(_e25816, _e25908);
}
let _e25962 = phi_2597_;
let _e25966 = bitcast<i32>((_e25757 * _e25760));
local_224 = _e25966;
local_225 = ((_e25962.member_1 * _e25761) + _e25962.member);
let _e25969 = local_224;
let _e25970 = local_225;
let _e25971 = (_e25969 + _e25970);
let _e25973 = (bitcast<i32>(_e277) - 1i);
let _e25975 = select(_e25973, _e25971, (_e25971 < _e25973));
let _e25980 = global_5.member[bitcast<u32>(select(0i, _e25975, (_e25975 > 0i)))];
let _e25981 = local_224;
let _e25983 = local_225;
let _e25984 = ((2i * _e25981) + _e25983);
let _e25986 = select(_e25973, _e25984, (_e25984 < _e25973));
let _e25991 = global_5.member[bitcast<u32>(select(0i, _e25986, (_e25986 > 0i)))];
let _e25992 = local_225;
let _e25994 = select(_e25973, _e25992, (_e25992 < _e25973));
let _e25999 = global_5.member[bitcast<u32>(select(0i, _e25994, (_e25994 > 0i)))];
let _e26000 = local_225;
let _e26011 = global_1.member.member_2.member;
let _e26012 = (((((f32(_e25962.member) + 0.5f) / f32(_e25761)) * 2f) - 1f) * _e26011);
let _e26019 = global_1.member.member_2.member_1;
let _e26020 = ((1f - (((f32(_e25962.member_1) + 0.5f) / f32(_e25762)) * 2f)) * _e26019);
let _e26022 = global_1.member.member_3;
let _e26030 = global_1.member.member_4;
let _e26037 = ((_e26022.member * _e26012) + (_e26030.member * _e26020));
let _e26038 = ((_e26022.member_1 * _e26012) + (_e26030.member_1 * _e26020));
let _e26039 = ((_e26022.member_2 * _e26012) + (_e26030.member_2 * _e26020));
let _e26042 = global_1.member.member_2.member_3;
let _e26043 = (_e26042 != 0u);
let _e26045 = global_1.member.member_5;
let _e26052 = select((_e26045.member + _e26037), _e26045.member, _e26043);
let _e26053 = select((_e26045.member_1 + _e26038), _e26045.member_1, _e26043);
let _e26054 = select((_e26045.member_2 + _e26039), _e26045.member_2, _e26043);
let _e26056 = global_1.member.member_6;
let _e26063 = select(_e26056.member, (_e26056.member + _e26037), _e26043);
let _e26064 = select(_e26056.member_1, (_e26056.member_1 + _e26038), _e26043);
let _e26065 = select(_e26056.member_2, (_e26056.member_2 + _e26039), _e26043);
let _e26070 = (((_e26052 * _e26052) + (_e26053 * _e26053)) + (_e26054 * _e26054));
let _e26074 = (1f / sqrt(select(0f, _e26070, (_e26070 > 0f))));
let _e26075 = (_e26052 * _e26074);
let _e26076 = (_e26053 * _e26074);
let _e26077 = (_e26054 * _e26074);
let _e26078 = (_e593 - _e26063);
let _e26079 = (_e605 - _e26064);
let _e26080 = (_e618 - _e26065);
let _e26085 = (((_e26078 * _e26075) + (_e26079 * _e26076)) + (_e26080 * _e26077));
let _e26090 = (((_e26078 * _e631) + (_e26079 * _e644)) + (_e26080 * _e657));
let _e26095 = (((_e26075 * _e631) + (_e26076 * _e644)) + (_e26077 * _e657));
let _e26098 = ((_e26076 * _e657) - (_e26077 * _e644));
let _e26101 = ((_e26077 * _e631) - (_e26075 * _e657));
let _e26104 = ((_e26075 * _e644) - (_e26076 * _e631));
let _e26109 = (((_e26098 * _e26098) + (_e26101 * _e26101)) + (_e26104 * _e26104));
let _e26112 = (1f / select(1e-9f, _e26109, (_e26109 > 1e-9f)));
let _e26115 = ((_e26085 - (_e26095 * _e26090)) * _e26112);
let _e26118 = (((_e26095 * _e26085) - _e26090) * _e26112);
let _e26126 = global_1.member.member_12.member_16;
let _e26128 = -(_e26095);
let _e26131 = global_1.member.member_13.member_2;
let _e26132 = (_e26131 * _e26131);
let _e26136 = ((1f + _e26132) - ((2f * _e26131) * _e26128));
let _e26138 = select(1e-9f, _e26136, (_e26136 > 1e-9f));
let _e26150 = global_1.member.member_13.member_3;
if (_e26150 == 2u) {
let _e26155 = (0.5f - (0.5f * _e26128));
let _e26157 = select(0f, _e26155, (_e26155 > 0f));
let _e26161 = (sqrt(select(0f, _e26157, (_e26157 > 0f))) * 255f);
let _e26162 = (255f - 1f);
let _e26164 = select(0f, _e26161, (_e26161 > 0f));
let _e26166 = select(_e26162, _e26164, (_e26164 < _e26162));
let _e26173 = select(0i, select(select(i32(_e26166), i32(-2147483648), (_e26166 < -2147483600f)), 2147483647i, (_e26166 > 2147483500f)), (_e26166 == _e26166));
let _e26177 = (_e26173 - select(0i, 1i, (_e26166 < f32(_e26173))));
let _e26180 = global_1.member.member_13.member_11;
let _e26181 = bitcast<i32>(_e26180);
let _e26182 = (_e26181 + _e26177);
let _e26184 = (bitcast<i32>(_e283) - 1i);
let _e26186 = select(_e26184, _e26182, (_e26182 < _e26184));
let _e26191 = global_2.member[bitcast<u32>(select(0i, _e26186, (_e26186 > 0i)))];
let _e26193 = (_e26181 + (_e26177 + 1i));
let _e26195 = select(_e26184, _e26193, (_e26193 < _e26184));
let _e26200 = global_2.member[bitcast<u32>(select(0i, _e26195, (_e26195 > 0i)))];
phi_3030_ = (_e26191 + ((_e26200 - _e26191) * (_e26161 - f32(_e26177))));
} else {
phi_3030_ = select(((1f - _e26132) / (_e26138 * sqrt(select(0f, _e26138, (_e26138 > 0f))))), (0.75f * (1f + (_e26128 * _e26128))), (_e26150 == 1u));
}
let _e26207 = phi_3030_;
let _e26210 = ((_e552 * _e26126) * (_e26207 * (0.25f / 3.1415927f)));
let _e26213 = global_1.member.member_13.member_6;
if (false || (true && (_e26213 > 0u))) {
let _e26225 = global_1.member.member_13.member_7;
let _e26226 = bitcast<i32>(_e26225);
let _e26229 = global_1.member.member_13.member_8;
let _e26230 = bitcast<i32>(_e26229);
let _e26233 = global_1.member.member_13.member_9;
let _e26234 = bitcast<i32>(_e26233);
let _e26237 = global_1.member.member_13.member_4;
let _e26243 = global_1.member.member_13.member_5;
let _e26247 = f32(_e26226);
let _e26252 = (((((_e26063 + (_e26075 * _e26115)) - _e26237.member) / (_e26243.member - _e26237.member)) * _e26247) - 0.5f);
let _e26253 = (_e26247 - 1f);
let _e26255 = select(0f, _e26252, (_e26252 > 0f));
let _e26257 = select(_e26253, _e26255, (_e26255 < _e26253));
let _e26258 = f32(_e26230);
let _e26263 = (((((_e26064 + (_e26076 * _e26115)) - _e26237.member_1) / (_e26243.member_1 - _e26237.member_1)) * _e26258) - 0.5f);
let _e26264 = (_e26258 - 1f);
let _e26266 = select(0f, _e26263, (_e26263 > 0f));
let _e26268 = select(_e26264, _e26266, (_e26266 < _e26264));
let _e26269 = f32(_e26234);
let _e26274 = (((((_e26065 + (_e26077 * _e26115)) - _e26237.member_2) / (_e26243.member_2 - _e26237.member_2)) * _e26269) - 0.5f);
let _e26275 = (_e26269 - 1f);
let _e26277 = select(0f, _e26274, (_e26274 > 0f));
let _e26279 = select(_e26275, _e26277, (_e26277 < _e26275));
let _e26281 = select(0f, _e26257, (_e26257 > 0f));
let _e26283 = select(1e6f, _e26281, (_e26281 < 1e6f));
let _e26290 = select(0i, select(select(i32(_e26283), i32(-2147483648), (_e26283 < -2147483600f)), 2147483647i, (_e26283 > 2147483500f)), (_e26283 == _e26283));
let _e26294 = (_e26290 - select(0i, 1i, (_e26283 < f32(_e26290))));
let _e26296 = select(0f, _e26268, (_e26268 > 0f));
let _e26298 = select(1e6f, _e26296, (_e26296 < 1e6f));
let _e26305 = select(0i, select(select(i32(_e26298), i32(-2147483648), (_e26298 < -2147483600f)), 2147483647i, (_e26298 > 2147483500f)), (_e26298 == _e26298));
let _e26309 = (_e26305 - select(0i, 1i, (_e26298 < f32(_e26305))));
let _e26311 = select(0f, _e26279, (_e26279 > 0f));
let _e26313 = select(1e6f, _e26311, (_e26311 < 1e6f));
let _e26320 = select(0i, select(select(i32(_e26313), i32(-2147483648), (_e26313 < -2147483600f)), 2147483647i, (_e26313 > 2147483500f)), (_e26313 == _e26313));
let _e26324 = (_e26320 - select(0i, 1i, (_e26313 < f32(_e26320))));
let _e26328 = (_e26268 - f32(_e26309));
let _e26330 = (_e26279 - f32(_e26324));
local_222 = (_e26257 - f32(_e26294));
let _e26331 = (_e26294 + 1i);
let _e26333 = select(_e26331, 0i, (_e26331 < 0i));
if (_e26333 >= _e26226) {
phi_3162_ = (_e26226 - 1i);
} else {
phi_3162_ = _e26333;
}
let _e26337 = phi_3162_;
local_223 = (_e26337 - _e26294);
let _e26339 = (_e26309 + 1i);
let _e26341 = select(_e26339, 0i, (_e26339 < 0i));
if (_e26341 >= _e26230) {
phi_3175_ = (_e26230 - 1i);
} else {
phi_3175_ = _e26341;
}
let _e26345 = phi_3175_;
let _e26347 = ((_e26345 - _e26309) * _e26226);
let _e26348 = (_e26324 + 1i);
let _e26350 = select(_e26348, 0i, (_e26348 < 0i));
if (_e26350 >= _e26234) {
phi_3189_ = (_e26234 - 1i);
} else {
phi_3189_ = _e26350;
}
let _e26354 = phi_3189_;
let _e26360 = global_1.member.member_13.member_10;
let _e26366 = ((bitcast<i32>(_e26360) + (((_e26324 * _e26230) + _e26309) * _e26226)) + _e26294);
let _e26368 = (bitcast<i32>(_e283) - 1i);
let _e26370 = select(_e26368, _e26366, (_e26366 < _e26368));
let _e26375 = global_2.member[bitcast<u32>(select(0i, _e26370, (_e26370 > 0i)))];
let _e26376 = local_222;
let _e26379 = local_223;
let _e26380 = (_e26366 + _e26379);
let _e26382 = select(_e26368, _e26380, (_e26380 < _e26368));
let _e26387 = global_2.member[bitcast<u32>(select(0i, _e26382, (_e26382 > 0i)))];
let _e26388 = local_222;
let _e26391 = (1f - _e26328);
let _e26393 = (_e26366 + _e26347);
let _e26395 = select(_e26368, _e26393, (_e26393 < _e26368));
let _e26400 = global_2.member[bitcast<u32>(select(0i, _e26395, (_e26395 > 0i)))];
let _e26401 = local_222;
let _e26404 = local_223;
let _e26405 = (_e26393 + _e26404);
let _e26407 = select(_e26368, _e26405, (_e26405 < _e26368));
let _e26412 = global_2.member[bitcast<u32>(select(0i, _e26407, (_e26407 > 0i)))];
let _e26413 = local_222;
let _e26418 = (_e26366 + (((_e26354 - _e26324) * _e26226) * _e26230));
let _e26420 = select(_e26368, _e26418, (_e26418 < _e26368));
let _e26425 = global_2.member[bitcast<u32>(select(0i, _e26420, (_e26420 > 0i)))];
let _e26426 = local_222;
let _e26429 = local_223;
let _e26430 = (_e26418 + _e26429);
let _e26432 = select(_e26368, _e26430, (_e26430 < _e26368));
let _e26437 = global_2.member[bitcast<u32>(select(0i, _e26432, (_e26432 > 0i)))];
let _e26438 = local_222;
let _e26442 = (_e26418 + _e26347);
let _e26444 = select(_e26368, _e26442, (_e26442 < _e26368));
let _e26449 = global_2.member[bitcast<u32>(select(0i, _e26444, (_e26444 > 0i)))];
let _e26450 = local_222;
let _e26453 = local_223;
let _e26454 = (_e26442 + _e26453);
let _e26456 = select(_e26368, _e26454, (_e26454 < _e26368));
let _e26461 = global_2.member[bitcast<u32>(select(0i, _e26456, (_e26456 > 0i)))];
let _e26462 = local_222;
phi_3390_ = (_e26210 * ((((((_e26375 * (1f - _e26376)) + (_e26387 * _e26388)) * _e26391) + (((_e26400 * (1f - _e26401)) + (_e26412 * _e26413)) * _e26328)) * (1f - _e26330)) + (((((_e26425 * (1f - _e26426)) + (_e26437 * _e26438)) * _e26391) + (((_e26449 * (1f - _e26450)) + (_e26461 * _e26462)) * _e26328)) * _e26330)));
} else {
phi_3390_ = _e26210;
}
let _e26473 = phi_3390_;
let _e26476 = global_1.member.member_12.member_14;
let _e26479 = global_1.member.member_12.member_15;
let _e26480 = (_e26115 / _e26476);
let _e26482 = select(-1e9f, _e26480, (_e26480 > -1e9f));
let _e26484 = select(1e9f, _e26482, (_e26482 < 1e9f));
let _e26491 = select(0i, select(select(i32(_e26484), i32(-2147483648), (_e26484 < -2147483600f)), 2147483647i, (_e26484 > 2147483500f)), (_e26484 == _e26484));
phi_3433_ = vec3<f32>(0f, 0f, 0f);
phi_3436_ = 0i;
loop {
let _e26501 = phi_3433_;
let _e26503 = phi_3436_;
local_245 = _e26501;
local_246 = _e26501;
local_247 = _e26501;
let _e26504 = (_e26503 < 4i);
if _e26504 {
let _e26507 = (f32((((_e26491 - select(0i, 1i, (_e26484 < f32(_e26491)))) + -1i) + _e26503)) * _e26476);
let _e26509 = ((_e26507 - _e26115) / _e26479);
let _e26516 = ((-0.5f * 1.953f) * (_e26509 * _e26509));
let _e26518 = select(-87f, _e26516, (_e26516 > -87f));
let _e26520 = select(88f, _e26518, (_e26518 < 88f));
let _e26522 = ((_e26520 * 1.442695f) + 0.5f);
let _e26524 = select(-127f, _e26522, (_e26522 > -127f));
let _e26526 = select(128f, _e26524, (_e26524 < 128f));
let _e26533 = select(0i, select(select(i32(_e26526), i32(-2147483648), (_e26526 < -2147483600f)), 2147483647i, (_e26526 > 2147483500f)), (_e26526 == _e26526));
let _e26537 = (_e26533 - select(0i, 1i, (_e26526 < f32(_e26533))));
let _e26538 = f32(_e26537);
let _e26542 = ((_e26520 - (_e26538 * 0.6933594f)) - (_e26538 * -2.1219444e-4f));
if (_e26213 == 0u) {
let _e26711 = (_e26507 - _e25980);
phi_3799_ = type_25(_e26118, select(0f, _e26711, (_e26711 > 0f)));
} else {
let _e26572 = global_1.member.member_12.member_12;
let _e26575 = global_1.member.member_12.member_4;
let _e26578 = global_1.member.member_12.member_13;
let _e26584 = global_1.member.member.member;
let _e26586 = (_e26118 / _e709);
local_219 = bitcast<i32>((_e26572 + (_e26575 * _e26578)));
local_220 = _e299;
local_221 = bitcast<i32>(_e26584);
let _e26587 = f32(_e26213);
let _e26589 = select(0f, _e26586, (_e26586 > 0f));
let _e26592 = (select(1f, _e26589, (_e26589 < 1f)) * _e26587);
let _e26593 = (_e26587 - 1f);
let _e26595 = select(0f, _e26593, (_e26593 > 0f));
let _e26597 = select(0f, _e26592, (_e26592 > 0f));
let _e26599 = select(_e26595, _e26597, (_e26597 < _e26595));
let _e26606 = select(0i, select(select(i32(_e26599), i32(-2147483648), (_e26599 < -2147483600f)), 2147483647i, (_e26599 > 2147483500f)), (_e26599 == _e26599));
let _e26610 = (_e26606 - select(0i, 1i, (_e26599 < f32(_e26606))));
if (_e26610 > 0i) {
let _e26613 = local_219;
let _e26614 = local_221;
let _e26617 = local_220;
let _e26618 = ((_e26613 + ((_e26610 - 1i) * _e26614)) + _e26617);
let _e26620 = (bitcast<i32>(_e286) - 1i);
let _e26622 = select(_e26620, _e26618, (_e26618 < _e26620));
let _e26627 = global_7.member[bitcast<u32>(select(0i, _e26622, (_e26622 > 0i)))];
phi_3642_ = _e26627;
} else {
phi_3642_ = 0f;
}
let _e26629 = phi_3642_;
let _e26630 = local_219;
let _e26631 = local_221;
let _e26634 = local_220;
let _e26635 = ((_e26630 + (_e26610 * _e26631)) + _e26634);
let _e26637 = (bitcast<i32>(_e286) - 1i);
let _e26639 = select(_e26637, _e26635, (_e26635 < _e26637));
let _e26644 = global_7.member[bitcast<u32>(select(0i, _e26639, (_e26639 > 0i)))];
let _e26651 = (_e25991 - _e25980);
let _e26654 = ((_e26507 - _e25980) / select(1e-9f, _e26651, (_e26651 > 1e-9f)));
local_216 = 0i;
local_217 = _e26000;
local_218 = _e25966;
let _e26656 = select(0f, _e26654, (_e26654 > 0f));
let _e26659 = (select(1f, _e26656, (_e26656 < 1f)) * _e26587);
let _e26661 = select(0f, _e26659, (_e26659 > 0f));
let _e26663 = select(_e26595, _e26661, (_e26661 < _e26595));
let _e26670 = select(0i, select(select(i32(_e26663), i32(-2147483648), (_e26663 < -2147483600f)), 2147483647i, (_e26663 > 2147483500f)), (_e26663 == _e26663));
let _e26674 = (_e26670 - select(0i, 1i, (_e26663 < f32(_e26670))));
if (_e26674 > 0i) {
let _e26677 = local_216;
let _e26678 = local_218;
let _e26681 = local_217;
let _e26682 = ((_e26677 + ((_e26674 - 1i) * _e26678)) + _e26681);
let _e26684 = select(_e26637, _e26682, (_e26682 < _e26637));
let _e26689 = global_7.member[bitcast<u32>(select(0i, _e26684, (_e26684 > 0i)))];
phi_3769_ = _e26689;
} else {
phi_3769_ = 0f;
}
let _e26691 = phi_3769_;
let _e26692 = local_216;
let _e26693 = local_218;
let _e26696 = local_217;
let _e26697 = ((_e26692 + (_e26674 * _e26693)) + _e26696);
let _e26699 = select(_e26637, _e26697, (_e26697 < _e26637));
let _e26704 = global_7.member[bitcast<u32>(select(0i, _e26699, (_e26699 > 0i)))];
phi_3799_ = type_25((_e26629 + ((_e26644 - _e26629) * (_e26592 - f32(_e26610)))), (_e26691 + ((_e26704 - _e26691) * (_e26659 - f32(_e26674)))));
}
let _e26716 = phi_3799_;
let _e26722 = (_e26716.member + _e26716.member_1);
let _e26725 = global_1.member.member_13.member;
let _e26730 = -((_e26725.member * _e26722));
let _e26732 = select(-87f, _e26730, (_e26730 > -87f));
let _e26734 = select(88f, _e26732, (_e26732 < 88f));
let _e26736 = ((_e26734 * 1.442695f) + 0.5f);
let _e26738 = select(-127f, _e26736, (_e26736 > -127f));
let _e26740 = select(128f, _e26738, (_e26738 < 128f));
let _e26747 = select(0i, select(select(i32(_e26740), i32(-2147483648), (_e26740 < -2147483600f)), 2147483647i, (_e26740 > 2147483500f)), (_e26740 == _e26740));
let _e26751 = (_e26747 - select(0i, 1i, (_e26740 < f32(_e26747))));
let _e26752 = f32(_e26751);
let _e26756 = ((_e26734 - (_e26752 * 0.6933594f)) - (_e26752 * -2.1219444e-4f));
let _e26778 = -((_e26725.member_1 * _e26722));
let _e26780 = select(-87f, _e26778, (_e26778 > -87f));
let _e26782 = select(88f, _e26780, (_e26780 < 88f));
let _e26784 = ((_e26782 * 1.442695f) + 0.5f);
let _e26786 = select(-127f, _e26784, (_e26784 > -127f));
let _e26788 = select(128f, _e26786, (_e26786 < 128f));
let _e26795 = select(0i, select(select(i32(_e26788), i32(-2147483648), (_e26788 < -2147483600f)), 2147483647i, (_e26788 > 2147483500f)), (_e26788 == _e26788));
let _e26799 = (_e26795 - select(0i, 1i, (_e26788 < f32(_e26795))));
let _e26800 = f32(_e26799);
let _e26804 = ((_e26782 - (_e26800 * 0.6933594f)) - (_e26800 * -2.1219444e-4f));
let _e26826 = -((_e26725.member_2 * _e26722));
let _e26828 = select(-87f, _e26826, (_e26826 > -87f));
let _e26830 = select(88f, _e26828, (_e26828 < 88f));
let _e26832 = ((_e26830 * 1.442695f) + 0.5f);
let _e26834 = select(-127f, _e26832, (_e26832 > -127f));
let _e26836 = select(128f, _e26834, (_e26834 < 128f));
let _e26843 = select(0i, select(select(i32(_e26836), i32(-2147483648), (_e26836 < -2147483600f)), 2147483647i, (_e26836 > 2147483500f)), (_e26836 == _e26836));
let _e26847 = (_e26843 - select(0i, 1i, (_e26836 < f32(_e26843))));
let _e26848 = f32(_e26847);
let _e26852 = ((_e26830 - (_e26848 * 0.6933594f)) - (_e26848 * -2.1219444e-4f));
let _e26873 = select(0f, (select(0f, (0.70403045f * (1f - ((1f - ((1f + (_e26542 * (1f + (_e26542 * (0.5f + (_e26542 * (0.16666667f + (_e26542 * (0.041666668f + (_e26542 * (0.008333334f + (_e26542 * (0.001388889f + (_e26542 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e26537 + 127i)) << bitcast<u32>(23i))))) * 1.1652954f))), (bitcast<f32>((bitcast<u32>(_e26509) & 2147483647u)) <= 1f)) * (_e26476 / _e26479)), ((_e26507 >= _e25980) && (_e26507 <= select(_e25999, _e25991, (_e25991 < _e25999)))));
phi_3434_ = vec3<f32>((_e26501.x + (((1f + (_e26756 * (1f + (_e26756 * (0.5f + (_e26756 * (0.16666667f + (_e26756 * (0.041666668f + (_e26756 * (0.008333334f + (_e26756 * (0.001388889f + (_e26756 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e26751 + 127i)) << bitcast<u32>(23i)))) * _e26873)), (_e26501.y + (((1f + (_e26804 * (1f + (_e26804 * (0.5f + (_e26804 * (0.16666667f + (_e26804 * (0.041666668f + (_e26804 * (0.008333334f + (_e26804 * (0.001388889f + (_e26804 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e26799 + 127i)) << bitcast<u32>(23i)))) * _e26873)), (_e26501.z + (((1f + (_e26852 * (1f + (_e26852 * (0.5f + (_e26852 * (0.16666667f + (_e26852 * (0.041666668f + (_e26852 * (0.008333334f + (_e26852 * (0.001388889f + (_e26852 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e26847 + 127i)) << bitcast<u32>(23i)))) * _e26873)));
phi_3437_ = (_e26503 + 1i);
} else {
phi_3434_ = vec3<f32>();
phi_3437_ = i32();
}
let _e26886 = phi_3434_;
let _e26888 = phi_3437_;
continue;
continuing {
phi_3433_ = _e26886;
phi_3436_ = _e26888;
break if !(_e26504);
}
}
let _e26892 = global_1.member.member_13.member_1;
let _e26900 = local_245;
let _e26904 = local_246;
let _e26908 = local_247;
let _e26914 = select(0f, _e26115, (((_e26118 >= 0f) && (_e26118 < _e709)) && (_e26115 > 0f)));
if _e471 {
phi_4060_ = type_26(_e25908, _e25816);
} else {
phi_4060_ = type_26(_e25816, _e25908);
}
let _e26925 = phi_4060_;
let _e26928 = (_e25909 && (((_e26914 > 0f) && (_e26914 < _e25999)) && true));
let _e26931 = global_1.member.member_18.member;
let _e26932 = (((select(_e25934, (1f - _e25934), (_e25919 >= 0f)) - select(_e25953, (1f - _e25953), (_e25938 >= 0f))) * (1f / _e25916)) * _e26931);
let _e26936 = select(0f, (((((_e670 * _e26892.member) * _e26900.x) * _e26473) * 1f) * _e26932), _e26928);
let _e26937 = select(0f, (((((_e683 * _e26892.member_1) * _e26904.y) * _e26473) * 1f) * _e26932), _e26928);
let _e26938 = select(0f, (((((_e696 * _e26892.member_2) * _e26908.z) * _e26473) * 1f) * _e26932), _e26928);
let _e26942 = (bitcast<f32>((bitcast<u32>(_e26936) & 2147483647u)) >= 1073741800f);
let _e26943 = (1f / 1048576f);
let _e26946 = ((_e26936 * select(1f, _e26943, _e26942)) + 0.5f);
let _e26948 = select(-1073741800f, _e26946, (_e26946 > -1073741800f));
let _e26950 = select(1073741800f, _e26948, (_e26948 < 1073741800f));
let _e26957 = select(0i, select(select(i32(_e26950), i32(-2147483648), (_e26950 < -2147483600f)), 2147483647i, (_e26950 > 2147483500f)), (_e26950 == _e26950));
let _e26961 = (_e26957 - select(0i, 1i, (_e26950 < f32(_e26957))));
let _e26962 = select(0i, 20i, _e26942);
let _e26966 = (bitcast<u32>(_e26961) << bitcast<u32>((_e26962 & 31i)));
let _e26973 = bitcast<u32>(((_e26961 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e26962) & 31i))));
let _e26977 = (bitcast<f32>((bitcast<u32>(_e26937) & 2147483647u)) >= 1073741800f);
let _e26980 = ((_e26937 * select(1f, _e26943, _e26977)) + 0.5f);
let _e26982 = select(-1073741800f, _e26980, (_e26980 > -1073741800f));
let _e26984 = select(1073741800f, _e26982, (_e26982 < 1073741800f));
let _e26991 = select(0i, select(select(i32(_e26984), i32(-2147483648), (_e26984 < -2147483600f)), 2147483647i, (_e26984 > 2147483500f)), (_e26984 == _e26984));
let _e26995 = (_e26991 - select(0i, 1i, (_e26984 < f32(_e26991))));
let _e26996 = select(0i, 20i, _e26977);
let _e27000 = (bitcast<u32>(_e26995) << bitcast<u32>((_e26996 & 31i)));
let _e27007 = bitcast<u32>(((_e26995 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e26996) & 31i))));
let _e27011 = (bitcast<f32>((bitcast<u32>(_e26938) & 2147483647u)) >= 1073741800f);
let _e27014 = ((_e26938 * select(1f, _e26943, _e27011)) + 0.5f);
let _e27016 = select(-1073741800f, _e27014, (_e27014 > -1073741800f));
let _e27018 = select(1073741800f, _e27016, (_e27016 < 1073741800f));
let _e27025 = select(0i, select(select(i32(_e27018), i32(-2147483648), (_e27018 < -2147483600f)), 2147483647i, (_e27018 > 2147483500f)), (_e27018 == _e27018));
let _e27029 = (_e27025 - select(0i, 1i, (_e27018 < f32(_e27025))));
let _e27030 = select(0i, 20i, _e27011);
let _e27034 = (bitcast<u32>(_e27029) << bitcast<u32>((_e27030 & 31i)));
let _e27041 = bitcast<u32>(((_e27029 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e27030) & 31i))));
let _e27046 = bitcast<i32>(bitcast<u32>((((_e26925.member_1 * _e25761) + _e26925.member) * 6i)));
if ((_e26966 | _e26973) == 0u) {
} else {
let _e27049 = bitcast<u32>(_e27046);
if (_e27049 < _e288) {
let _e27053 = atomicAdd((&global_8.member[_e27049]), _e26966);
phi_4293_ = _e27053;
} else {
phi_4293_ = 0u;
}
let _e27055 = phi_4293_;
let _e27059 = (_e26973 + select(0u, 1u, ((_e27055 + _e26966) < _e26966)));
if (_e27059 == 0u) {
} else {
let _e27061 = (_e27049 + 1u);
if (_e27061 < _e288) {
let _e27065 = atomicAdd((&global_8.member[_e27061]), _e27059);
}
}
}
if ((_e27000 | _e27007) == 0u) {
} else {
let _e27069 = bitcast<u32>((_e27046 + 2i));
if (_e27069 < _e288) {
let _e27073 = atomicAdd((&global_8.member[_e27069]), _e27000);
phi_4323_ = _e27073;
} else {
phi_4323_ = 0u;
}
let _e27075 = phi_4323_;
let _e27079 = (_e27007 + select(0u, 1u, ((_e27075 + _e27000) < _e27000)));
if (_e27079 == 0u) {
} else {
let _e27081 = (_e27069 + 1u);
if (_e27081 < _e288) {
let _e27085 = atomicAdd((&global_8.member[_e27081]), _e27079);
}
}
}
if ((_e27034 | _e27041) == 0u) {
} else {
let _e27089 = bitcast<u32>((_e27046 + 4i));
if (_e27089 < _e288) {
let _e27093 = atomicAdd((&global_8.member[_e27089]), _e27034);
phi_4353_ = _e27093;
} else {
phi_4353_ = 0u;
}
let _e27095 = phi_4353_;
let _e27099 = (_e27041 + select(0u, 1u, ((_e27095 + _e27034) < _e27034)));
if (_e27099 == 0u) {
} else {
let _e27101 = (_e27089 + 1u);
if (_e27101 < _e288) {
let _e27105 = atomicAdd((&global_8.member[_e27101]), _e27099);
}
}
}
phi_2493_ = (_e25906 + 1i);
} else {
phi_2493_ = i32();
}
let _e27108 = phi_2493_;
continue;
continuing {
phi_2492_ = _e27108;
break if !(_e25909);
}
}
phi_2339_ = (_e25813 + 1i);
} else {
phi_2339_ = i32();
}
let _e27112 = phi_2339_;
continue;
continuing {
phi_2338_ = _e27112;
break if !(_e25814);
}
}
} else {
if (_e291.member_2 == 1u) {
let _e11927 = global_1.member.member_1.member;
let _e11930 = global_1.member.member_1.member_1;
let _e11931 = bitcast<i32>(_e11927);
let _e11932 = bitcast<i32>(_e11930);
if _e471 {
phi_4424_ = type_26(_e11932, _e11931);
} else {
phi_4424_ = type_26(_e11931, _e11932);
}
let _e11936 = phi_4424_;
let _e11940 = f32((_e316 + 15i));
let _e11942 = select(_e11940, _e396, (_e396 < _e11940));
let _e11944 = select(_e332, _e11942, (_e11942 > _e332));
let _e11946 = select(_e11940, _e11944, (_e11944 < _e11940));
let _e11953 = select(0i, select(select(i32(_e11946), i32(-2147483648), (_e11946 < -2147483600f)), 2147483647i, (_e11946 > 2147483500f)), (_e11946 == _e11946));
let _e11957 = (_e11953 - select(0i, 1i, (_e11946 < f32(_e11953))));
let _e11958 = bitcast<i32>(_e11957);
let _e11960 = select(_e332, _e383, (_e383 > _e332));
let _e11962 = select(_e332, _e11960, (_e11960 > _e332));
let _e11964 = select(_e11940, _e11962, (_e11962 < _e11940));
let _e11971 = select(0i, select(select(i32(_e11964), i32(-2147483648), (_e11964 < -2147483600f)), 2147483647i, (_e11964 > 2147483500f)), (_e11964 == _e11964));
let _e11975 = (_e11971 - select(0i, 1i, (_e11964 < f32(_e11971))));
let _e11976 = bitcast<i32>(_e11975);
if (_e11958 < _e11936.member) {
phi_4499_ = _e11958;
} else {
phi_4499_ = (_e11936.member - 1i);
}
let _e11980 = phi_4499_;
let _e11981 = (_e11936.member_1 - 1i);
let _e11982 = (_e784 == 0u);
if _e11982 {
let _e19540 = select(_e863, 0u, (_e863 == _e784));
let _e19544 = select(_e941, 0u, ((_e941 == _e784) || (_e941 == _e863)));
let _e19552 = ((select(0u, 1u, (_e784 > 0u)) + select(0u, 1u, (_e19540 > 0u))) + select(0u, 1u, (_e19544 > 0u)));
if (_e19552 == 0u) {
phi_4537_ = 0i;
loop {
let _e24597 = phi_4537_;
let _e24598 = (_e24597 < 16i);
if _e24598 {
let _e24600 = (_e11976 + (_e24597 & 15i));
let _e24604 = (((f32(_e24600) + 0.5f) * 1f) - 0.5f);
let _e24608 = (-(((_e434 * _e24604) + _e460)) / _e447);
let _e24615 = bitcast<f32>((bitcast<u32>(((_e484 * _e24604) + ((_e497 * _e24608) + _e510))) & 2147483647u));
let _e24622 = bitcast<f32>((bitcast<u32>(((_e523 * _e24604) + ((_e536 * _e24608) + _e549))) & 2147483647u));
let _e24626 = (((0.5f * (_e24615 + _e24622)) / _e552) + _e735);
let _e24627 = (1f / 1f);
let _e24635 = ((((_e24608 + _e24626) + 0.5f) * _e24627) - 0.5f);
let _e24636 = f32(_e11981);
let _e24637 = (0f - 1f);
let _e24639 = select(_e24637, _e24635, (_e24635 > _e24637));
let _e24641 = select(_e24636, _e24639, (_e24639 < _e24636));
let _e24648 = select(0i, select(select(i32(_e24641), i32(-2147483648), (_e24641 < -2147483600f)), 2147483647i, (_e24641 > 2147483500f)), (_e24641 == _e24641));
let _e24653 = (((((_e24608 - _e24626) + 0.5f) * _e24627) - 0.5f) + 1f);
let _e24654 = (_e24636 + 1f);
let _e24656 = select(0f, _e24653, (_e24653 > 0f));
let _e24658 = select(_e24654, _e24656, (_e24656 < _e24654));
let _e24665 = select(0i, select(select(i32(_e24658), i32(-2147483648), (_e24658 < -2147483600f)), 2147483647i, (_e24658 > 2147483500f)), (_e24658 == _e24658));
let _e24676 = ((1e-4f * 1f) * _e552);
let _e24678 = select(_e24622, _e24615, (_e24615 > _e24622));
let _e24680 = select(_e24676, _e24678, (_e24678 > _e24676));
let _e24682 = select(_e24622, _e24615, (_e24615 < _e24622));
let _e24684 = select(_e24676, _e24682, (_e24682 > _e24676));
let _e24686 = (0.5f * (_e24680 + _e24684));
let _e24687 = (0.5f / _e24684);
let _e24688 = (1f / _e24680);
phi_4691_ = 0i;
loop {
let _e24690 = phi_4691_;
let _e24692 = (((_e24665 - select(0i, 1i, (_e24658 < f32(_e24665)))) + (_e24597 >> bitcast<u32>(4u))) + bitcast<i32>(_e24690));
let _e24693 = (_e24692 <= select(-1i, (_e24648 - select(0i, 1i, (_e24641 < f32(_e24648)))), (_e24600 <= _e11980)));
if _e24693 {
let _e24699 = (((((f32(_e24692) + 0.5f) * 1f) - 0.5f) - _e24608) * _e552);
let _e24700 = (_e552 * 1f);
let _e24702 = (0.5f * _e24700);
let _e24703 = (_e24699 + _e24702);
let _e24704 = -(_e24703);
let _e24707 = (_e24686 - select(_e24704, _e24703, (_e24703 > _e24704)));
let _e24709 = select(0f, _e24707, (_e24707 > 0f));
let _e24711 = select(_e24684, _e24709, (_e24709 < _e24684));
let _e24714 = (_e24707 - _e24684);
let _e24718 = (((_e24711 * (_e24711 * _e24687)) + select(0f, _e24714, (_e24714 > 0f))) * _e24688);
let _e24722 = (_e24699 - _e24702);
let _e24723 = -(_e24722);
let _e24726 = (_e24686 - select(_e24723, _e24722, (_e24722 > _e24723)));
let _e24728 = select(0f, _e24726, (_e24726 > 0f));
let _e24730 = select(_e24684, _e24728, (_e24728 < _e24684));
let _e24733 = (_e24726 - _e24684);
let _e24737 = (((_e24730 * (_e24730 * _e24687)) + select(0f, _e24733, (_e24733 > 0f))) * _e24688);
if _e471 {
phi_4796_ = type_26(_e24692, _e24600);
} else {
phi_4796_ = type_26(_e24600, _e24692);
}
let _e24746 = phi_4796_;
let _e24750 = bitcast<i32>((_e11927 * _e11930));
local_214 = _e24750;
local_215 = ((_e24746.member_1 * _e11931) + _e24746.member);
let _e24753 = local_214;
let _e24754 = local_215;
let _e24755 = (_e24753 + _e24754);
let _e24757 = (bitcast<i32>(_e277) - 1i);
let _e24759 = select(_e24757, _e24755, (_e24755 < _e24757));
let _e24764 = global_5.member[bitcast<u32>(select(0i, _e24759, (_e24759 > 0i)))];
let _e24765 = local_214;
let _e24767 = local_215;
let _e24768 = ((2i * _e24765) + _e24767);
let _e24770 = select(_e24757, _e24768, (_e24768 < _e24757));
let _e24775 = global_5.member[bitcast<u32>(select(0i, _e24770, (_e24770 > 0i)))];
let _e24776 = local_215;
let _e24778 = select(_e24757, _e24776, (_e24776 < _e24757));
let _e24783 = global_5.member[bitcast<u32>(select(0i, _e24778, (_e24778 > 0i)))];
let _e24784 = local_215;
let _e24795 = global_1.member.member_2.member;
let _e24796 = (((((f32(_e24746.member) + 0.5f) / f32(_e11931)) * 2f) - 1f) * _e24795);
let _e24803 = global_1.member.member_2.member_1;
let _e24804 = ((1f - (((f32(_e24746.member_1) + 0.5f) / f32(_e11932)) * 2f)) * _e24803);
let _e24806 = global_1.member.member_3;
let _e24814 = global_1.member.member_4;
let _e24821 = ((_e24806.member * _e24796) + (_e24814.member * _e24804));
let _e24822 = ((_e24806.member_1 * _e24796) + (_e24814.member_1 * _e24804));
let _e24823 = ((_e24806.member_2 * _e24796) + (_e24814.member_2 * _e24804));
let _e24826 = global_1.member.member_2.member_3;
let _e24827 = (_e24826 != 0u);
let _e24829 = global_1.member.member_5;
let _e24836 = select((_e24829.member + _e24821), _e24829.member, _e24827);
let _e24837 = select((_e24829.member_1 + _e24822), _e24829.member_1, _e24827);
let _e24838 = select((_e24829.member_2 + _e24823), _e24829.member_2, _e24827);
let _e24840 = global_1.member.member_6;
let _e24847 = select(_e24840.member, (_e24840.member + _e24821), _e24827);
let _e24848 = select(_e24840.member_1, (_e24840.member_1 + _e24822), _e24827);
let _e24849 = select(_e24840.member_2, (_e24840.member_2 + _e24823), _e24827);
let _e24854 = (((_e24836 * _e24836) + (_e24837 * _e24837)) + (_e24838 * _e24838));
let _e24857 = sqrt(select(0f, _e24854, (_e24854 > 0f)));
let _e24858 = (1f / _e24857);
let _e24859 = (_e24836 * _e24858);
let _e24860 = (_e24837 * _e24858);
let _e24861 = (_e24838 * _e24858);
let _e24862 = (_e593 - _e24847);
let _e24863 = (_e605 - _e24848);
let _e24864 = (_e618 - _e24849);
let _e24869 = (((_e24862 * _e24859) + (_e24863 * _e24860)) + (_e24864 * _e24861));
let _e24874 = (((_e24862 * _e631) + (_e24863 * _e644)) + (_e24864 * _e657));
let _e24879 = (((_e24859 * _e631) + (_e24860 * _e644)) + (_e24861 * _e657));
let _e24882 = ((_e24860 * _e657) - (_e24861 * _e644));
let _e24885 = ((_e24861 * _e631) - (_e24859 * _e657));
let _e24888 = ((_e24859 * _e644) - (_e24860 * _e631));
let _e24893 = (((_e24882 * _e24882) + (_e24885 * _e24885)) + (_e24888 * _e24888));
let _e24896 = (1f / select(1e-9f, _e24893, (_e24893 > 1e-9f)));
let _e24899 = ((_e24869 - (_e24879 * _e24874)) * _e24896);
let _e24902 = (((_e24879 * _e24869) - _e24874) * _e24896);
let _e24908 = -(_e24879);
let _e24911 = global_1.member.member_13.member_2;
let _e24912 = (_e24911 * _e24911);
let _e24916 = ((1f + _e24912) - ((2f * _e24911) * _e24908));
let _e24918 = select(1e-9f, _e24916, (_e24916 > 1e-9f));
let _e24930 = global_1.member.member_13.member_3;
if (_e24930 == 2u) {
let _e24935 = (0.5f - (0.5f * _e24908));
let _e24937 = select(0f, _e24935, (_e24935 > 0f));
let _e24941 = (sqrt(select(0f, _e24937, (_e24937 > 0f))) * 255f);
let _e24942 = (255f - 1f);
let _e24944 = select(0f, _e24941, (_e24941 > 0f));
let _e24946 = select(_e24942, _e24944, (_e24944 < _e24942));
let _e24953 = select(0i, select(select(i32(_e24946), i32(-2147483648), (_e24946 < -2147483600f)), 2147483647i, (_e24946 > 2147483500f)), (_e24946 == _e24946));
let _e24957 = (_e24953 - select(0i, 1i, (_e24946 < f32(_e24953))));
let _e24960 = global_1.member.member_13.member_11;
let _e24961 = bitcast<i32>(_e24960);
let _e24962 = (_e24961 + _e24957);
let _e24964 = (bitcast<i32>(_e283) - 1i);
let _e24966 = select(_e24964, _e24962, (_e24962 < _e24964));
let _e24971 = global_2.member[bitcast<u32>(select(0i, _e24966, (_e24966 > 0i)))];
let _e24973 = (_e24961 + (_e24957 + 1i));
let _e24975 = select(_e24964, _e24973, (_e24973 < _e24964));
let _e24980 = global_2.member[bitcast<u32>(select(0i, _e24975, (_e24975 > 0i)))];
phi_5223_ = (_e24971 + ((_e24980 - _e24971) * (_e24941 - f32(_e24957))));
} else {
phi_5223_ = select(((1f - _e24912) / (_e24918 * sqrt(select(0f, _e24918, (_e24918 > 0f))))), (0.75f * (1f + (_e24908 * _e24908))), (_e24930 == 1u));
}
let _e24987 = phi_5223_;
let _e24999 = global_1.member.member_13.member_7;
let _e25000 = bitcast<i32>(_e24999);
let _e25003 = global_1.member.member_13.member_8;
let _e25004 = bitcast<i32>(_e25003);
let _e25007 = global_1.member.member_13.member_9;
let _e25008 = bitcast<i32>(_e25007);
let _e25011 = global_1.member.member_13.member_4;
let _e25017 = global_1.member.member_13.member_5;
let _e25021 = f32(_e25000);
let _e25026 = (((((_e24847 + (_e24859 * _e24899)) - _e25011.member) / (_e25017.member - _e25011.member)) * _e25021) - 0.5f);
let _e25027 = (_e25021 - 1f);
let _e25029 = select(0f, _e25026, (_e25026 > 0f));
let _e25031 = select(_e25027, _e25029, (_e25029 < _e25027));
let _e25032 = f32(_e25004);
let _e25037 = (((((_e24848 + (_e24860 * _e24899)) - _e25011.member_1) / (_e25017.member_1 - _e25011.member_1)) * _e25032) - 0.5f);
let _e25038 = (_e25032 - 1f);
let _e25040 = select(0f, _e25037, (_e25037 > 0f));
let _e25042 = select(_e25038, _e25040, (_e25040 < _e25038));
let _e25043 = f32(_e25008);
let _e25048 = (((((_e24849 + (_e24861 * _e24899)) - _e25011.member_2) / (_e25017.member_2 - _e25011.member_2)) * _e25043) - 0.5f);
let _e25049 = (_e25043 - 1f);
let _e25051 = select(0f, _e25048, (_e25048 > 0f));
let _e25053 = select(_e25049, _e25051, (_e25051 < _e25049));
let _e25055 = select(0f, _e25031, (_e25031 > 0f));
let _e25057 = select(1e6f, _e25055, (_e25055 < 1e6f));
let _e25064 = select(0i, select(select(i32(_e25057), i32(-2147483648), (_e25057 < -2147483600f)), 2147483647i, (_e25057 > 2147483500f)), (_e25057 == _e25057));
let _e25068 = (_e25064 - select(0i, 1i, (_e25057 < f32(_e25064))));
let _e25070 = select(0f, _e25042, (_e25042 > 0f));
let _e25072 = select(1e6f, _e25070, (_e25070 < 1e6f));
let _e25079 = select(0i, select(select(i32(_e25072), i32(-2147483648), (_e25072 < -2147483600f)), 2147483647i, (_e25072 > 2147483500f)), (_e25072 == _e25072));
let _e25083 = (_e25079 - select(0i, 1i, (_e25072 < f32(_e25079))));
let _e25085 = select(0f, _e25053, (_e25053 > 0f));
let _e25087 = select(1e6f, _e25085, (_e25085 < 1e6f));
let _e25094 = select(0i, select(select(i32(_e25087), i32(-2147483648), (_e25087 < -2147483600f)), 2147483647i, (_e25087 > 2147483500f)), (_e25087 == _e25087));
let _e25098 = (_e25094 - select(0i, 1i, (_e25087 < f32(_e25094))));
let _e25102 = (_e25042 - f32(_e25083));
let _e25104 = (_e25053 - f32(_e25098));
local_212 = (_e25031 - f32(_e25068));
let _e25105 = (_e25068 + 1i);
let _e25107 = select(_e25105, 0i, (_e25105 < 0i));
if (_e25107 >= _e25000) {
phi_5355_ = (_e25000 - 1i);
} else {
phi_5355_ = _e25107;
}
let _e25111 = phi_5355_;
local_213 = (_e25111 - _e25068);
let _e25113 = (_e25083 + 1i);
let _e25115 = select(_e25113, 0i, (_e25113 < 0i));
if (_e25115 >= _e25004) {
phi_5368_ = (_e25004 - 1i);
} else {
phi_5368_ = _e25115;
}
let _e25119 = phi_5368_;
let _e25121 = ((_e25119 - _e25083) * _e25000);
let _e25122 = (_e25098 + 1i);
let _e25124 = select(_e25122, 0i, (_e25122 < 0i));
if (_e25124 >= _e25008) {
phi_5382_ = (_e25008 - 1i);
} else {
phi_5382_ = _e25124;
}
let _e25128 = phi_5382_;
let _e25134 = global_1.member.member_13.member_10;
let _e25140 = ((bitcast<i32>(_e25134) + (((_e25098 * _e25004) + _e25083) * _e25000)) + _e25068);
let _e25142 = (bitcast<i32>(_e283) - 1i);
let _e25144 = select(_e25142, _e25140, (_e25140 < _e25142));
let _e25149 = global_2.member[bitcast<u32>(select(0i, _e25144, (_e25144 > 0i)))];
let _e25150 = local_212;
let _e25153 = local_213;
let _e25154 = (_e25140 + _e25153);
let _e25156 = select(_e25142, _e25154, (_e25154 < _e25142));
let _e25161 = global_2.member[bitcast<u32>(select(0i, _e25156, (_e25156 > 0i)))];
let _e25162 = local_212;
let _e25165 = (1f - _e25102);
let _e25167 = (_e25140 + _e25121);
let _e25169 = select(_e25142, _e25167, (_e25167 < _e25142));
let _e25174 = global_2.member[bitcast<u32>(select(0i, _e25169, (_e25169 > 0i)))];
let _e25175 = local_212;
let _e25178 = local_213;
let _e25179 = (_e25167 + _e25178);
let _e25181 = select(_e25142, _e25179, (_e25179 < _e25142));
let _e25186 = global_2.member[bitcast<u32>(select(0i, _e25181, (_e25181 > 0i)))];
let _e25187 = local_212;
let _e25192 = (_e25140 + (((_e25128 - _e25098) * _e25000) * _e25004));
let _e25194 = select(_e25142, _e25192, (_e25192 < _e25142));
let _e25199 = global_2.member[bitcast<u32>(select(0i, _e25194, (_e25194 > 0i)))];
let _e25200 = local_212;
let _e25203 = local_213;
let _e25204 = (_e25192 + _e25203);
let _e25206 = select(_e25142, _e25204, (_e25204 < _e25142));
let _e25211 = global_2.member[bitcast<u32>(select(0i, _e25206, (_e25206 > 0i)))];
let _e25212 = local_212;
let _e25216 = (_e25192 + _e25121);
let _e25218 = select(_e25142, _e25216, (_e25216 < _e25142));
let _e25223 = global_2.member[bitcast<u32>(select(0i, _e25218, (_e25218 > 0i)))];
let _e25224 = local_212;
let _e25227 = local_213;
let _e25228 = (_e25216 + _e25227);
let _e25230 = select(_e25142, _e25228, (_e25228 < _e25142));
let _e25235 = global_2.member[bitcast<u32>(select(0i, _e25230, (_e25230 > 0i)))];
let _e25236 = local_212;
let _e25245 = ((_e24857 * (_e24987 * (0.25f / 3.1415927f))) * ((((((_e25149 * (1f - _e25150)) + (_e25161 * _e25162)) * _e25165) + (((_e25174 * (1f - _e25175)) + (_e25186 * _e25187)) * _e25102)) * (1f - _e25104)) + (((((_e25199 * (1f - _e25200)) + (_e25211 * _e25212)) * _e25165) + (((_e25223 * (1f - _e25224)) + (_e25235 * _e25236)) * _e25102)) * _e25104)));
let _e25248 = global_1.member.member_12.member_12;
let _e25251 = global_1.member.member_12.member_4;
let _e25254 = global_1.member.member_12.member_13;
let _e25260 = global_1.member.member.member;
let _e25262 = (_e24902 / _e709);
local_209 = bitcast<i32>((_e25248 + (_e25251 * _e25254)));
local_210 = _e299;
local_211 = bitcast<i32>(_e25260);
let _e25265 = global_1.member.member_13.member_6;
let _e25266 = f32(_e25265);
let _e25268 = select(0f, _e25262, (_e25262 > 0f));
let _e25271 = (select(1f, _e25268, (_e25268 < 1f)) * _e25266);
let _e25272 = (_e25266 - 1f);
let _e25274 = select(0f, _e25272, (_e25272 > 0f));
let _e25276 = select(0f, _e25271, (_e25271 > 0f));
let _e25278 = select(_e25274, _e25276, (_e25276 < _e25274));
let _e25285 = select(0i, select(select(i32(_e25278), i32(-2147483648), (_e25278 < -2147483600f)), 2147483647i, (_e25278 > 2147483500f)), (_e25278 == _e25278));
let _e25289 = (_e25285 - select(0i, 1i, (_e25278 < f32(_e25285))));
if (_e25289 > 0i) {
let _e25292 = local_209;
let _e25293 = local_211;
let _e25296 = local_210;
let _e25297 = ((_e25292 + ((_e25289 - 1i) * _e25293)) + _e25296);
let _e25299 = (bitcast<i32>(_e286) - 1i);
let _e25301 = select(_e25299, _e25297, (_e25297 < _e25299));
let _e25306 = global_7.member[bitcast<u32>(select(0i, _e25301, (_e25301 > 0i)))];
phi_5686_ = _e25306;
} else {
phi_5686_ = 0f;
}
let _e25308 = phi_5686_;
let _e25309 = local_209;
let _e25310 = local_211;
let _e25313 = local_210;
let _e25314 = ((_e25309 + (_e25289 * _e25310)) + _e25313);
let _e25316 = (bitcast<i32>(_e286) - 1i);
let _e25318 = select(_e25316, _e25314, (_e25314 < _e25316));
let _e25323 = global_7.member[bitcast<u32>(select(0i, _e25318, (_e25318 > 0i)))];
let _e25330 = (_e24775 - _e24764);
let _e25333 = ((_e24899 - _e24764) / select(1e-9f, _e25330, (_e25330 > 1e-9f)));
local_206 = 0i;
local_207 = _e24784;
local_208 = _e24750;
let _e25335 = select(0f, _e25333, (_e25333 > 0f));
let _e25338 = (select(1f, _e25335, (_e25335 < 1f)) * _e25266);
let _e25340 = select(0f, _e25338, (_e25338 > 0f));
let _e25342 = select(_e25274, _e25340, (_e25340 < _e25274));
let _e25349 = select(0i, select(select(i32(_e25342), i32(-2147483648), (_e25342 < -2147483600f)), 2147483647i, (_e25342 > 2147483500f)), (_e25342 == _e25342));
let _e25353 = (_e25349 - select(0i, 1i, (_e25342 < f32(_e25349))));
if (_e25353 > 0i) {
let _e25356 = local_206;
let _e25357 = local_208;
let _e25360 = local_207;
let _e25361 = ((_e25356 + ((_e25353 - 1i) * _e25357)) + _e25360);
let _e25363 = select(_e25316, _e25361, (_e25361 < _e25316));
let _e25368 = global_7.member[bitcast<u32>(select(0i, _e25363, (_e25363 > 0i)))];
phi_5813_ = _e25368;
} else {
phi_5813_ = 0f;
}
let _e25370 = phi_5813_;
let _e25371 = local_206;
let _e25372 = local_208;
let _e25375 = local_207;
let _e25376 = ((_e25371 + (_e25353 * _e25372)) + _e25375);
let _e25378 = select(_e25316, _e25376, (_e25376 < _e25316));
let _e25383 = global_7.member[bitcast<u32>(select(0i, _e25378, (_e25378 > 0i)))];
let _e25389 = ((_e25308 + ((_e25323 - _e25308) * (_e25271 - f32(_e25289)))) + (_e25370 + ((_e25383 - _e25370) * (_e25338 - f32(_e25353)))));
let _e25392 = global_1.member.member_13.member;
let _e25397 = -((_e25392.member * _e25389));
let _e25399 = select(-87f, _e25397, (_e25397 > -87f));
let _e25401 = select(88f, _e25399, (_e25399 < 88f));
let _e25403 = ((_e25401 * 1.442695f) + 0.5f);
let _e25405 = select(-127f, _e25403, (_e25403 > -127f));
let _e25407 = select(128f, _e25405, (_e25405 < 128f));
let _e25414 = select(0i, select(select(i32(_e25407), i32(-2147483648), (_e25407 < -2147483600f)), 2147483647i, (_e25407 > 2147483500f)), (_e25407 == _e25407));
let _e25418 = (_e25414 - select(0i, 1i, (_e25407 < f32(_e25414))));
let _e25419 = f32(_e25418);
let _e25423 = ((_e25401 - (_e25419 * 0.6933594f)) - (_e25419 * -2.1219444e-4f));
let _e25445 = -((_e25392.member_1 * _e25389));
let _e25447 = select(-87f, _e25445, (_e25445 > -87f));
let _e25449 = select(88f, _e25447, (_e25447 < 88f));
let _e25451 = ((_e25449 * 1.442695f) + 0.5f);
let _e25453 = select(-127f, _e25451, (_e25451 > -127f));
let _e25455 = select(128f, _e25453, (_e25453 < 128f));
let _e25462 = select(0i, select(select(i32(_e25455), i32(-2147483648), (_e25455 < -2147483600f)), 2147483647i, (_e25455 > 2147483500f)), (_e25455 == _e25455));
let _e25466 = (_e25462 - select(0i, 1i, (_e25455 < f32(_e25462))));
let _e25467 = f32(_e25466);
let _e25471 = ((_e25449 - (_e25467 * 0.6933594f)) - (_e25467 * -2.1219444e-4f));
let _e25493 = -((_e25392.member_2 * _e25389));
let _e25495 = select(-87f, _e25493, (_e25493 > -87f));
let _e25497 = select(88f, _e25495, (_e25495 < 88f));
let _e25499 = ((_e25497 * 1.442695f) + 0.5f);
let _e25501 = select(-127f, _e25499, (_e25499 > -127f));
let _e25503 = select(128f, _e25501, (_e25501 < 128f));
let _e25510 = select(0i, select(select(i32(_e25503), i32(-2147483648), (_e25503 < -2147483600f)), 2147483647i, (_e25503 > 2147483500f)), (_e25503 == _e25503));
let _e25514 = (_e25510 - select(0i, 1i, (_e25503 < f32(_e25510))));
let _e25515 = f32(_e25514);
let _e25519 = ((_e25497 - (_e25515 * 0.6933594f)) - (_e25515 * -2.1219444e-4f));
let _e25542 = global_1.member.member_13.member_1;
let _e25555 = select(0f, _e24899, (((_e24902 >= 0f) && (_e24902 < _e709)) && (_e24899 > 0f)));
if _e471 {
phi_6077_ = type_26(_e24692, _e24600);
} else {
phi_6077_ = type_26(_e24600, _e24692);
}
let _e25566 = phi_6077_;
let _e25569 = (_e24693 && (((_e25555 > 0f) && (_e25555 < _e24783)) && true));
let _e25572 = global_1.member.member_18.member;
let _e25573 = (((select(_e24718, (1f - _e24718), (_e24703 >= 0f)) - select(_e24737, (1f - _e24737), (_e24722 >= 0f))) * (1f / _e24700)) * _e25572);
let _e25577 = select(0f, (((((_e670 * _e25542.member) * ((1f + (_e25423 * (1f + (_e25423 * (0.5f + (_e25423 * (0.16666667f + (_e25423 * (0.041666668f + (_e25423 * (0.008333334f + (_e25423 * (0.001388889f + (_e25423 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e25418 + 127i)) << bitcast<u32>(23i))))) * _e25245) * 1f) * _e25573), _e25569);
let _e25578 = select(0f, (((((_e683 * _e25542.member_1) * ((1f + (_e25471 * (1f + (_e25471 * (0.5f + (_e25471 * (0.16666667f + (_e25471 * (0.041666668f + (_e25471 * (0.008333334f + (_e25471 * (0.001388889f + (_e25471 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e25466 + 127i)) << bitcast<u32>(23i))))) * _e25245) * 1f) * _e25573), _e25569);
let _e25579 = select(0f, (((((_e696 * _e25542.member_2) * ((1f + (_e25519 * (1f + (_e25519 * (0.5f + (_e25519 * (0.16666667f + (_e25519 * (0.041666668f + (_e25519 * (0.008333334f + (_e25519 * (0.001388889f + (_e25519 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e25514 + 127i)) << bitcast<u32>(23i))))) * _e25245) * 1f) * _e25573), _e25569);
let _e25583 = (bitcast<f32>((bitcast<u32>(_e25577) & 2147483647u)) >= 1073741800f);
let _e25584 = (1f / 1048576f);
let _e25587 = ((_e25577 * select(1f, _e25584, _e25583)) + 0.5f);
let _e25589 = select(-1073741800f, _e25587, (_e25587 > -1073741800f));
let _e25591 = select(1073741800f, _e25589, (_e25589 < 1073741800f));
let _e25598 = select(0i, select(select(i32(_e25591), i32(-2147483648), (_e25591 < -2147483600f)), 2147483647i, (_e25591 > 2147483500f)), (_e25591 == _e25591));
let _e25602 = (_e25598 - select(0i, 1i, (_e25591 < f32(_e25598))));
let _e25603 = select(0i, 20i, _e25583);
let _e25607 = (bitcast<u32>(_e25602) << bitcast<u32>((_e25603 & 31i)));
let _e25614 = bitcast<u32>(((_e25602 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25603) & 31i))));
let _e25618 = (bitcast<f32>((bitcast<u32>(_e25578) & 2147483647u)) >= 1073741800f);
let _e25621 = ((_e25578 * select(1f, _e25584, _e25618)) + 0.5f);
let _e25623 = select(-1073741800f, _e25621, (_e25621 > -1073741800f));
let _e25625 = select(1073741800f, _e25623, (_e25623 < 1073741800f));
let _e25632 = select(0i, select(select(i32(_e25625), i32(-2147483648), (_e25625 < -2147483600f)), 2147483647i, (_e25625 > 2147483500f)), (_e25625 == _e25625));
let _e25636 = (_e25632 - select(0i, 1i, (_e25625 < f32(_e25632))));
let _e25637 = select(0i, 20i, _e25618);
let _e25641 = (bitcast<u32>(_e25636) << bitcast<u32>((_e25637 & 31i)));
let _e25648 = bitcast<u32>(((_e25636 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25637) & 31i))));
let _e25652 = (bitcast<f32>((bitcast<u32>(_e25579) & 2147483647u)) >= 1073741800f);
let _e25655 = ((_e25579 * select(1f, _e25584, _e25652)) + 0.5f);
let _e25657 = select(-1073741800f, _e25655, (_e25655 > -1073741800f));
let _e25659 = select(1073741800f, _e25657, (_e25657 < 1073741800f));
let _e25666 = select(0i, select(select(i32(_e25659), i32(-2147483648), (_e25659 < -2147483600f)), 2147483647i, (_e25659 > 2147483500f)), (_e25659 == _e25659));
let _e25670 = (_e25666 - select(0i, 1i, (_e25659 < f32(_e25666))));
let _e25671 = select(0i, 20i, _e25652);
let _e25675 = (bitcast<u32>(_e25670) << bitcast<u32>((_e25671 & 31i)));
let _e25682 = bitcast<u32>(((_e25670 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25671) & 31i))));
let _e25687 = bitcast<i32>(bitcast<u32>((((_e25566.member_1 * _e11931) + _e25566.member) * 6i)));
if ((_e25607 | _e25614) == 0u) {
} else {
let _e25690 = bitcast<u32>(_e25687);
if (_e25690 < _e288) {
let _e25694 = atomicAdd((&global_8.member[_e25690]), _e25607);
phi_6310_ = _e25694;
} else {
phi_6310_ = 0u;
}
let _e25696 = phi_6310_;
let _e25700 = (_e25614 + select(0u, 1u, ((_e25696 + _e25607) < _e25607)));
if (_e25700 == 0u) {
} else {
let _e25702 = (_e25690 + 1u);
if (_e25702 < _e288) {
let _e25706 = atomicAdd((&global_8.member[_e25702]), _e25700);
}
}
}
if ((_e25641 | _e25648) == 0u) {
} else {
let _e25710 = bitcast<u32>((_e25687 + 2i));
if (_e25710 < _e288) {
let _e25714 = atomicAdd((&global_8.member[_e25710]), _e25641);
phi_6340_ = _e25714;
} else {
phi_6340_ = 0u;
}
let _e25716 = phi_6340_;
let _e25720 = (_e25648 + select(0u, 1u, ((_e25716 + _e25641) < _e25641)));
if (_e25720 == 0u) {
} else {
let _e25722 = (_e25710 + 1u);
if (_e25722 < _e288) {
let _e25726 = atomicAdd((&global_8.member[_e25722]), _e25720);
}
}
}
if ((_e25675 | _e25682) == 0u) {
} else {
let _e25730 = bitcast<u32>((_e25687 + 4i));
if (_e25730 < _e288) {
let _e25734 = atomicAdd((&global_8.member[_e25730]), _e25675);
phi_6370_ = _e25734;
} else {
phi_6370_ = 0u;
}
let _e25736 = phi_6370_;
let _e25740 = (_e25682 + select(0u, 1u, ((_e25736 + _e25675) < _e25675)));
if (_e25740 == 0u) {
} else {
let _e25742 = (_e25730 + 1u);
if (_e25742 < _e288) {
let _e25746 = atomicAdd((&global_8.member[_e25742]), _e25740);
}
}
}
phi_4692_ = (_e24690 + 1i);
} else {
phi_4692_ = i32();
}
let _e25749 = phi_4692_;
continue;
continuing {
phi_4691_ = _e25749;
break if !(_e24693);
}
}
phi_4538_ = (_e24597 + 1i);
} else {
phi_4538_ = i32();
}
let _e25753 = phi_4538_;
continue;
continuing {
phi_4537_ = _e25753;
break if !(_e24598);
}
}
} else {
if (_e19552 == 1u) {
phi_6419_ = 0i;
loop {
let _e22746 = phi_6419_;
let _e22747 = (_e22746 < 16i);
if _e22747 {
let _e22749 = (_e11976 + (_e22746 & 15i));
let _e22751 = (f32(_e22749) + 0.5f);
let _e22753 = ((_e22751 * 1f) - 0.5f);
let _e22757 = (-(((_e434 * _e22753) + _e460)) / _e447);
let _e22764 = bitcast<f32>((bitcast<u32>(((_e484 * _e22753) + ((_e497 * _e22757) + _e510))) & 2147483647u));
let _e22771 = bitcast<f32>((bitcast<u32>(((_e523 * _e22753) + ((_e536 * _e22757) + _e549))) & 2147483647u));
let _e22775 = (((0.5f * (_e22764 + _e22771)) / _e552) + _e735);
let _e22776 = (1f / 1f);
let _e22784 = ((((_e22757 + _e22775) + 0.5f) * _e22776) - 0.5f);
let _e22785 = f32(_e11981);
let _e22786 = (0f - 1f);
let _e22788 = select(_e22786, _e22784, (_e22784 > _e22786));
let _e22790 = select(_e22785, _e22788, (_e22788 < _e22785));
let _e22797 = select(0i, select(select(i32(_e22790), i32(-2147483648), (_e22790 < -2147483600f)), 2147483647i, (_e22790 > 2147483500f)), (_e22790 == _e22790));
let _e22802 = (((((_e22757 - _e22775) + 0.5f) * _e22776) - 0.5f) + 1f);
let _e22803 = (_e22785 + 1f);
let _e22805 = select(0f, _e22802, (_e22802 > 0f));
let _e22807 = select(_e22803, _e22805, (_e22805 < _e22803));
let _e22814 = select(0i, select(select(i32(_e22807), i32(-2147483648), (_e22807 < -2147483600f)), 2147483647i, (_e22807 > 2147483500f)), (_e22807 == _e22807));
let _e22825 = ((1e-4f * 1f) * _e552);
let _e22827 = select(_e22771, _e22764, (_e22764 > _e22771));
let _e22829 = select(_e22825, _e22827, (_e22827 > _e22825));
let _e22831 = select(_e22771, _e22764, (_e22764 < _e22771));
let _e22833 = select(_e22825, _e22831, (_e22831 > _e22825));
let _e22835 = (0.5f * (_e22829 + _e22833));
let _e22836 = (0.5f / _e22833);
let _e22837 = (1f / _e22829);
phi_6573_ = 0i;
loop {
let _e22839 = phi_6573_;
let _e22841 = (((_e22814 - select(0i, 1i, (_e22807 < f32(_e22814)))) + (_e22746 >> bitcast<u32>(4u))) + bitcast<i32>(_e22839));
let _e22842 = (_e22841 <= select(-1i, (_e22797 - select(0i, 1i, (_e22790 < f32(_e22797)))), (_e22749 <= _e11980)));
if _e22842 {
let _e22844 = (f32(_e22841) + 0.5f);
let _e22848 = ((((_e22844 * 1f) - 0.5f) - _e22757) * _e552);
let _e22849 = (_e552 * 1f);
let _e22851 = (0.5f * _e22849);
let _e22852 = (_e22848 + _e22851);
let _e22853 = -(_e22852);
let _e22856 = (_e22835 - select(_e22853, _e22852, (_e22852 > _e22853)));
let _e22858 = select(0f, _e22856, (_e22856 > 0f));
let _e22860 = select(_e22833, _e22858, (_e22858 < _e22833));
let _e22863 = (_e22856 - _e22833);
let _e22867 = (((_e22860 * (_e22860 * _e22836)) + select(0f, _e22863, (_e22863 > 0f))) * _e22837);
let _e22871 = (_e22848 - _e22851);
let _e22872 = -(_e22871);
let _e22875 = (_e22835 - select(_e22872, _e22871, (_e22871 > _e22872)));
let _e22877 = select(0f, _e22875, (_e22875 > 0f));
let _e22879 = select(_e22833, _e22877, (_e22877 < _e22833));
let _e22882 = (_e22875 - _e22833);
let _e22886 = (((_e22879 * (_e22879 * _e22836)) + select(0f, _e22882, (_e22882 > 0f))) * _e22837);
if _e471 {
phi_6678_ = type_26(_e22841, _e22749);
} else {
phi_6678_ = type_26(_e22749, _e22841);
}
let _e22895 = phi_6678_;
let _e22899 = bitcast<i32>((_e11927 * _e11930));
local_204 = _e22899;
local_205 = ((_e22895.member_1 * _e11931) + _e22895.member);
let _e22902 = local_204;
let _e22903 = local_205;
let _e22904 = (_e22902 + _e22903);
let _e22906 = (bitcast<i32>(_e277) - 1i);
let _e22908 = select(_e22906, _e22904, (_e22904 < _e22906));
let _e22913 = global_5.member[bitcast<u32>(select(0i, _e22908, (_e22908 > 0i)))];
let _e22914 = local_204;
let _e22916 = local_205;
let _e22917 = ((2i * _e22914) + _e22916);
let _e22919 = select(_e22906, _e22917, (_e22917 < _e22906));
let _e22924 = global_5.member[bitcast<u32>(select(0i, _e22919, (_e22919 > 0i)))];
let _e22925 = local_205;
let _e22927 = select(_e22906, _e22925, (_e22925 < _e22906));
let _e22932 = global_5.member[bitcast<u32>(select(0i, _e22927, (_e22927 > 0i)))];
let _e22933 = local_205;
let _e22936 = f32(_e11931);
let _e22937 = f32(_e11932);
let _e22944 = global_1.member.member_2.member;
let _e22945 = (((((f32(_e22895.member) + 0.5f) / _e22936) * 2f) - 1f) * _e22944);
let _e22952 = global_1.member.member_2.member_1;
let _e22953 = ((1f - (((f32(_e22895.member_1) + 0.5f) / _e22937) * 2f)) * _e22952);
let _e22955 = global_1.member.member_3;
let _e22963 = global_1.member.member_4;
let _e22970 = ((_e22955.member * _e22945) + (_e22963.member * _e22953));
let _e22971 = ((_e22955.member_1 * _e22945) + (_e22963.member_1 * _e22953));
let _e22972 = ((_e22955.member_2 * _e22945) + (_e22963.member_2 * _e22953));
let _e22975 = global_1.member.member_2.member_3;
let _e22976 = (_e22975 != 0u);
let _e22978 = global_1.member.member_5;
let _e22985 = select((_e22978.member + _e22970), _e22978.member, _e22976);
let _e22986 = select((_e22978.member_1 + _e22971), _e22978.member_1, _e22976);
let _e22987 = select((_e22978.member_2 + _e22972), _e22978.member_2, _e22976);
let _e22989 = global_1.member.member_6;
let _e22996 = select(_e22989.member, (_e22989.member + _e22970), _e22976);
let _e22997 = select(_e22989.member_1, (_e22989.member_1 + _e22971), _e22976);
let _e22998 = select(_e22989.member_2, (_e22989.member_2 + _e22972), _e22976);
let _e23003 = (((_e22985 * _e22985) + (_e22986 * _e22986)) + (_e22987 * _e22987));
let _e23006 = sqrt(select(0f, _e23003, (_e23003 > 0f)));
let _e23007 = (1f / _e23006);
let _e23008 = (_e22985 * _e23007);
let _e23009 = (_e22986 * _e23007);
let _e23010 = (_e22987 * _e23007);
let _e23011 = (_e593 - _e22996);
let _e23012 = (_e605 - _e22997);
let _e23013 = (_e618 - _e22998);
let _e23018 = (((_e23011 * _e23008) + (_e23012 * _e23009)) + (_e23013 * _e23010));
let _e23023 = (((_e23011 * _e631) + (_e23012 * _e644)) + (_e23013 * _e657));
let _e23028 = (((_e23008 * _e631) + (_e23009 * _e644)) + (_e23010 * _e657));
let _e23031 = ((_e23009 * _e657) - (_e23010 * _e644));
let _e23034 = ((_e23010 * _e631) - (_e23008 * _e657));
let _e23037 = ((_e23008 * _e644) - (_e23009 * _e631));
let _e23042 = (((_e23031 * _e23031) + (_e23034 * _e23034)) + (_e23037 * _e23037));
let _e23045 = (1f / select(1e-9f, _e23042, (_e23042 > 1e-9f)));
let _e23048 = ((_e23018 - (_e23028 * _e23023)) * _e23045);
let _e23051 = (((_e23028 * _e23018) - _e23023) * _e23045);
let _e23057 = -(_e23028);
let _e23060 = global_1.member.member_13.member_2;
let _e23061 = (_e23060 * _e23060);
let _e23065 = ((1f + _e23061) - ((2f * _e23060) * _e23057));
let _e23067 = select(1e-9f, _e23065, (_e23065 > 1e-9f));
let _e23079 = global_1.member.member_13.member_3;
if (_e23079 == 2u) {
let _e23084 = (0.5f - (0.5f * _e23057));
let _e23086 = select(0f, _e23084, (_e23084 > 0f));
let _e23090 = (sqrt(select(0f, _e23086, (_e23086 > 0f))) * 255f);
let _e23091 = (255f - 1f);
let _e23093 = select(0f, _e23090, (_e23090 > 0f));
let _e23095 = select(_e23091, _e23093, (_e23093 < _e23091));
let _e23102 = select(0i, select(select(i32(_e23095), i32(-2147483648), (_e23095 < -2147483600f)), 2147483647i, (_e23095 > 2147483500f)), (_e23095 == _e23095));
let _e23106 = (_e23102 - select(0i, 1i, (_e23095 < f32(_e23102))));
let _e23109 = global_1.member.member_13.member_11;
let _e23110 = bitcast<i32>(_e23109);
let _e23111 = (_e23110 + _e23106);
let _e23113 = (bitcast<i32>(_e283) - 1i);
let _e23115 = select(_e23113, _e23111, (_e23111 < _e23113));
let _e23120 = global_2.member[bitcast<u32>(select(0i, _e23115, (_e23115 > 0i)))];
let _e23122 = (_e23110 + (_e23106 + 1i));
let _e23124 = select(_e23113, _e23122, (_e23122 < _e23113));
let _e23129 = global_2.member[bitcast<u32>(select(0i, _e23124, (_e23124 > 0i)))];
phi_7105_ = (_e23120 + ((_e23129 - _e23120) * (_e23090 - f32(_e23106))));
} else {
phi_7105_ = select(((1f - _e23061) / (_e23067 * sqrt(select(0f, _e23067, (_e23067 > 0f))))), (0.75f * (1f + (_e23057 * _e23057))), (_e23079 == 1u));
}
let _e23136 = phi_7105_;
let _e23148 = global_1.member.member_13.member_7;
let _e23149 = bitcast<i32>(_e23148);
let _e23152 = global_1.member.member_13.member_8;
let _e23153 = bitcast<i32>(_e23152);
let _e23156 = global_1.member.member_13.member_9;
let _e23157 = bitcast<i32>(_e23156);
let _e23160 = global_1.member.member_13.member_4;
let _e23166 = global_1.member.member_13.member_5;
let _e23170 = f32(_e23149);
let _e23175 = (((((_e22996 + (_e23008 * _e23048)) - _e23160.member) / (_e23166.member - _e23160.member)) * _e23170) - 0.5f);
let _e23176 = (_e23170 - 1f);
let _e23178 = select(0f, _e23175, (_e23175 > 0f));
let _e23180 = select(_e23176, _e23178, (_e23178 < _e23176));
let _e23181 = f32(_e23153);
let _e23186 = (((((_e22997 + (_e23009 * _e23048)) - _e23160.member_1) / (_e23166.member_1 - _e23160.member_1)) * _e23181) - 0.5f);
let _e23187 = (_e23181 - 1f);
let _e23189 = select(0f, _e23186, (_e23186 > 0f));
let _e23191 = select(_e23187, _e23189, (_e23189 < _e23187));
let _e23192 = f32(_e23157);
let _e23197 = (((((_e22998 + (_e23010 * _e23048)) - _e23160.member_2) / (_e23166.member_2 - _e23160.member_2)) * _e23192) - 0.5f);
let _e23198 = (_e23192 - 1f);
let _e23200 = select(0f, _e23197, (_e23197 > 0f));
let _e23202 = select(_e23198, _e23200, (_e23200 < _e23198));
let _e23204 = select(0f, _e23180, (_e23180 > 0f));
let _e23206 = select(1e6f, _e23204, (_e23204 < 1e6f));
let _e23213 = select(0i, select(select(i32(_e23206), i32(-2147483648), (_e23206 < -2147483600f)), 2147483647i, (_e23206 > 2147483500f)), (_e23206 == _e23206));
let _e23217 = (_e23213 - select(0i, 1i, (_e23206 < f32(_e23213))));
let _e23219 = select(0f, _e23191, (_e23191 > 0f));
let _e23221 = select(1e6f, _e23219, (_e23219 < 1e6f));
let _e23228 = select(0i, select(select(i32(_e23221), i32(-2147483648), (_e23221 < -2147483600f)), 2147483647i, (_e23221 > 2147483500f)), (_e23221 == _e23221));
let _e23232 = (_e23228 - select(0i, 1i, (_e23221 < f32(_e23228))));
let _e23234 = select(0f, _e23202, (_e23202 > 0f));
let _e23236 = select(1e6f, _e23234, (_e23234 < 1e6f));
let _e23243 = select(0i, select(select(i32(_e23236), i32(-2147483648), (_e23236 < -2147483600f)), 2147483647i, (_e23236 > 2147483500f)), (_e23236 == _e23236));
let _e23247 = (_e23243 - select(0i, 1i, (_e23236 < f32(_e23243))));
let _e23251 = (_e23191 - f32(_e23232));
let _e23253 = (_e23202 - f32(_e23247));
local_202 = (_e23180 - f32(_e23217));
let _e23254 = (_e23217 + 1i);
let _e23256 = select(_e23254, 0i, (_e23254 < 0i));
if (_e23256 >= _e23149) {
phi_7237_ = (_e23149 - 1i);
} else {
phi_7237_ = _e23256;
}
let _e23260 = phi_7237_;
local_203 = (_e23260 - _e23217);
let _e23262 = (_e23232 + 1i);
let _e23264 = select(_e23262, 0i, (_e23262 < 0i));
if (_e23264 >= _e23153) {
phi_7250_ = (_e23153 - 1i);
} else {
phi_7250_ = _e23264;
}
let _e23268 = phi_7250_;
let _e23270 = ((_e23268 - _e23232) * _e23149);
let _e23271 = (_e23247 + 1i);
let _e23273 = select(_e23271, 0i, (_e23271 < 0i));
if (_e23273 >= _e23157) {
phi_7264_ = (_e23157 - 1i);
} else {
phi_7264_ = _e23273;
}
let _e23277 = phi_7264_;
let _e23283 = global_1.member.member_13.member_10;
let _e23289 = ((bitcast<i32>(_e23283) + (((_e23247 * _e23153) + _e23232) * _e23149)) + _e23217);
let _e23291 = (bitcast<i32>(_e283) - 1i);
let _e23293 = select(_e23291, _e23289, (_e23289 < _e23291));
let _e23298 = global_2.member[bitcast<u32>(select(0i, _e23293, (_e23293 > 0i)))];
let _e23299 = local_202;
let _e23302 = local_203;
let _e23303 = (_e23289 + _e23302);
let _e23305 = select(_e23291, _e23303, (_e23303 < _e23291));
let _e23310 = global_2.member[bitcast<u32>(select(0i, _e23305, (_e23305 > 0i)))];
let _e23311 = local_202;
let _e23314 = (1f - _e23251);
let _e23316 = (_e23289 + _e23270);
let _e23318 = select(_e23291, _e23316, (_e23316 < _e23291));
let _e23323 = global_2.member[bitcast<u32>(select(0i, _e23318, (_e23318 > 0i)))];
let _e23324 = local_202;
let _e23327 = local_203;
let _e23328 = (_e23316 + _e23327);
let _e23330 = select(_e23291, _e23328, (_e23328 < _e23291));
let _e23335 = global_2.member[bitcast<u32>(select(0i, _e23330, (_e23330 > 0i)))];
let _e23336 = local_202;
let _e23341 = (_e23289 + (((_e23277 - _e23247) * _e23149) * _e23153));
let _e23343 = select(_e23291, _e23341, (_e23341 < _e23291));
let _e23348 = global_2.member[bitcast<u32>(select(0i, _e23343, (_e23343 > 0i)))];
let _e23349 = local_202;
let _e23352 = local_203;
let _e23353 = (_e23341 + _e23352);
let _e23355 = select(_e23291, _e23353, (_e23353 < _e23291));
let _e23360 = global_2.member[bitcast<u32>(select(0i, _e23355, (_e23355 > 0i)))];
let _e23361 = local_202;
let _e23365 = (_e23341 + _e23270);
let _e23367 = select(_e23291, _e23365, (_e23365 < _e23291));
let _e23372 = global_2.member[bitcast<u32>(select(0i, _e23367, (_e23367 > 0i)))];
let _e23373 = local_202;
let _e23376 = local_203;
let _e23377 = (_e23365 + _e23376);
let _e23379 = select(_e23291, _e23377, (_e23377 < _e23291));
let _e23384 = global_2.member[bitcast<u32>(select(0i, _e23379, (_e23379 > 0i)))];
let _e23385 = local_202;
let _e23394 = ((_e23006 * (_e23136 * (0.25f / 3.1415927f))) * ((((((_e23298 * (1f - _e23299)) + (_e23310 * _e23311)) * _e23314) + (((_e23323 * (1f - _e23324)) + (_e23335 * _e23336)) * _e23251)) * (1f - _e23253)) + (((((_e23348 * (1f - _e23349)) + (_e23360 * _e23361)) * _e23314) + (((_e23372 * (1f - _e23373)) + (_e23384 * _e23385)) * _e23251)) * _e23253)));
let _e23397 = global_1.member.member_12.member_12;
let _e23400 = global_1.member.member_12.member_4;
let _e23403 = global_1.member.member_12.member_13;
let _e23409 = global_1.member.member.member;
let _e23411 = (_e23051 / _e709);
local_199 = bitcast<i32>((_e23397 + (_e23400 * _e23403)));
local_200 = _e299;
local_201 = bitcast<i32>(_e23409);
let _e23414 = global_1.member.member_13.member_6;
let _e23415 = f32(_e23414);
let _e23417 = select(0f, _e23411, (_e23411 > 0f));
let _e23420 = (select(1f, _e23417, (_e23417 < 1f)) * _e23415);
let _e23421 = (_e23415 - 1f);
let _e23423 = select(0f, _e23421, (_e23421 > 0f));
let _e23425 = select(0f, _e23420, (_e23420 > 0f));
let _e23427 = select(_e23423, _e23425, (_e23425 < _e23423));
let _e23434 = select(0i, select(select(i32(_e23427), i32(-2147483648), (_e23427 < -2147483600f)), 2147483647i, (_e23427 > 2147483500f)), (_e23427 == _e23427));
let _e23438 = (_e23434 - select(0i, 1i, (_e23427 < f32(_e23434))));
if (_e23438 > 0i) {
let _e23441 = local_199;
let _e23442 = local_201;
let _e23445 = local_200;
let _e23446 = ((_e23441 + ((_e23438 - 1i) * _e23442)) + _e23445);
let _e23448 = (bitcast<i32>(_e286) - 1i);
let _e23450 = select(_e23448, _e23446, (_e23446 < _e23448));
let _e23455 = global_7.member[bitcast<u32>(select(0i, _e23450, (_e23450 > 0i)))];
phi_7568_ = _e23455;
} else {
phi_7568_ = 0f;
}
let _e23457 = phi_7568_;
let _e23458 = local_199;
let _e23459 = local_201;
let _e23462 = local_200;
let _e23463 = ((_e23458 + (_e23438 * _e23459)) + _e23462);
let _e23465 = (bitcast<i32>(_e286) - 1i);
let _e23467 = select(_e23465, _e23463, (_e23463 < _e23465));
let _e23472 = global_7.member[bitcast<u32>(select(0i, _e23467, (_e23467 > 0i)))];
let _e23479 = (_e22924 - _e22913);
let _e23482 = ((_e23048 - _e22913) / select(1e-9f, _e23479, (_e23479 > 1e-9f)));
local_196 = 0i;
local_197 = _e22933;
local_198 = _e22899;
let _e23484 = select(0f, _e23482, (_e23482 > 0f));
let _e23487 = (select(1f, _e23484, (_e23484 < 1f)) * _e23415);
let _e23489 = select(0f, _e23487, (_e23487 > 0f));
let _e23491 = select(_e23423, _e23489, (_e23489 < _e23423));
let _e23498 = select(0i, select(select(i32(_e23491), i32(-2147483648), (_e23491 < -2147483600f)), 2147483647i, (_e23491 > 2147483500f)), (_e23491 == _e23491));
let _e23502 = (_e23498 - select(0i, 1i, (_e23491 < f32(_e23498))));
if (_e23502 > 0i) {
let _e23505 = local_196;
let _e23506 = local_198;
let _e23509 = local_197;
let _e23510 = ((_e23505 + ((_e23502 - 1i) * _e23506)) + _e23509);
let _e23512 = select(_e23465, _e23510, (_e23510 < _e23465));
let _e23517 = global_7.member[bitcast<u32>(select(0i, _e23512, (_e23512 > 0i)))];
phi_7695_ = _e23517;
} else {
phi_7695_ = 0f;
}
let _e23519 = phi_7695_;
let _e23520 = local_196;
let _e23521 = local_198;
let _e23524 = local_197;
let _e23525 = ((_e23520 + (_e23502 * _e23521)) + _e23524);
let _e23527 = select(_e23465, _e23525, (_e23525 < _e23465));
let _e23532 = global_7.member[bitcast<u32>(select(0i, _e23527, (_e23527 > 0i)))];
let _e23538 = ((_e23457 + ((_e23472 - _e23457) * (_e23420 - f32(_e23438)))) + (_e23519 + ((_e23532 - _e23519) * (_e23487 - f32(_e23502)))));
let _e23541 = global_1.member.member_13.member;
let _e23546 = -((_e23541.member * _e23538));
let _e23548 = select(-87f, _e23546, (_e23546 > -87f));
let _e23550 = select(88f, _e23548, (_e23548 < 88f));
let _e23552 = ((_e23550 * 1.442695f) + 0.5f);
let _e23554 = select(-127f, _e23552, (_e23552 > -127f));
let _e23556 = select(128f, _e23554, (_e23554 < 128f));
let _e23563 = select(0i, select(select(i32(_e23556), i32(-2147483648), (_e23556 < -2147483600f)), 2147483647i, (_e23556 > 2147483500f)), (_e23556 == _e23556));
let _e23567 = (_e23563 - select(0i, 1i, (_e23556 < f32(_e23563))));
let _e23568 = f32(_e23567);
let _e23572 = ((_e23550 - (_e23568 * 0.6933594f)) - (_e23568 * -2.1219444e-4f));
let _e23594 = -((_e23541.member_1 * _e23538));
let _e23596 = select(-87f, _e23594, (_e23594 > -87f));
let _e23598 = select(88f, _e23596, (_e23596 < 88f));
let _e23600 = ((_e23598 * 1.442695f) + 0.5f);
let _e23602 = select(-127f, _e23600, (_e23600 > -127f));
let _e23604 = select(128f, _e23602, (_e23602 < 128f));
let _e23611 = select(0i, select(select(i32(_e23604), i32(-2147483648), (_e23604 < -2147483600f)), 2147483647i, (_e23604 > 2147483500f)), (_e23604 == _e23604));
let _e23615 = (_e23611 - select(0i, 1i, (_e23604 < f32(_e23611))));
let _e23616 = f32(_e23615);
let _e23620 = ((_e23598 - (_e23616 * 0.6933594f)) - (_e23616 * -2.1219444e-4f));
let _e23642 = -((_e23541.member_2 * _e23538));
let _e23644 = select(-87f, _e23642, (_e23642 > -87f));
let _e23646 = select(88f, _e23644, (_e23644 < 88f));
let _e23648 = ((_e23646 * 1.442695f) + 0.5f);
let _e23650 = select(-127f, _e23648, (_e23648 > -127f));
let _e23652 = select(128f, _e23650, (_e23650 < 128f));
let _e23659 = select(0i, select(select(i32(_e23652), i32(-2147483648), (_e23652 < -2147483600f)), 2147483647i, (_e23652 > 2147483500f)), (_e23652 == _e23652));
let _e23663 = (_e23659 - select(0i, 1i, (_e23652 < f32(_e23659))));
let _e23664 = f32(_e23663);
let _e23668 = ((_e23646 - (_e23664 * 0.6933594f)) - (_e23664 * -2.1219444e-4f));
let _e23691 = global_1.member.member_13.member_1;
let _e23704 = select(0f, _e23048, (((_e23051 >= 0f) && (_e23051 < _e709)) && (_e23048 > 0f)));
let _e23706 = ((_e784 + _e19540) + _e19544);
let _e23707 = (_e23706 & 31u);
let _e23709 = (1u << bitcast<u32>(_e23707));
let _e23718 = bitcast<i32>((((_e11927 + _e23709) - 1u) >> bitcast<u32>(_e23707)));
let _e23719 = bitcast<i32>((((_e11930 + _e23709) - 1u) >> bitcast<u32>(_e23707)));
if _e471 {
phi_7985_ = type_26(_e23719, _e23718);
} else {
phi_7985_ = type_26(_e23718, _e23719);
}
let _e23723 = phi_7985_;
let _e23728 = f32((1i << bitcast<u32>(_e23707)));
let _e23729 = (1f / _e23728);
let _e23731 = ((_e22751 * _e23729) - 0.5f);
let _e23733 = ((_e22844 * _e23729) - 0.5f);
let _e23735 = select(-1f, _e23731, (_e23731 > -1f));
let _e23737 = select(1e6f, _e23735, (_e23735 < 1e6f));
let _e23744 = select(0i, select(select(i32(_e23737), i32(-2147483648), (_e23737 < -2147483600f)), 2147483647i, (_e23737 > 2147483500f)), (_e23737 == _e23737));
let _e23748 = (_e23744 - select(0i, 1i, (_e23737 < f32(_e23744))));
let _e23750 = select(-1f, _e23733, (_e23733 > -1f));
let _e23752 = select(1e6f, _e23750, (_e23750 < 1e6f));
let _e23759 = select(0i, select(select(i32(_e23752), i32(-2147483648), (_e23752 < -2147483600f)), 2147483647i, (_e23752 > 2147483500f)), (_e23752 == _e23752));
let _e23763 = (_e23759 - select(0i, 1i, (_e23752 < f32(_e23759))));
let _e23765 = (_e23731 - f32(_e23748));
let _e23767 = (_e23733 - f32(_e23763));
let _e23768 = (1f - _e23765);
let _e23769 = (1f - _e23767);
let _e23772 = select(_e23748, 0i, (_e23748 < 0i));
let _e23773 = (_e23772 >= _e23723.member);
if _e23773 {
phi_8063_ = (_e23723.member - 1i);
} else {
phi_8063_ = _e23772;
}
let _e23776 = phi_8063_;
let _e23778 = select(_e23763, 0i, (_e23763 < 0i));
let _e23779 = (_e23778 >= _e23723.member_1);
if _e23779 {
phi_8074_ = (_e23723.member_1 - 1i);
} else {
phi_8074_ = _e23778;
}
let _e23782 = phi_8074_;
let _e23786 = (((f32(_e23776) + 0.5f) * _e23728) - 0.5f);
let _e23790 = (((f32(_e23782) + 0.5f) * _e23728) - 0.5f);
if _e471 {
phi_8102_ = type_26(_e23782, _e23776);
} else {
phi_8102_ = type_26(_e23776, _e23782);
}
let _e23796 = phi_8102_;
let _e23802 = bitcast<i32>(((_e11927 + 1u) >> bitcast<u32>(1u)));
let _e23805 = global_1.member.member_18.member_6;
let _e23808 = global_1.member.member_18.member_7;
let _e23811 = global_1.member.member_18.member_8;
let _e23812 = (_e23706 == 0u);
if _e23812 {
phi_8153_ = 0u;
} else {
if (_e23706 == 1u) {
phi_8152_ = 0u;
} else {
if (_e23706 == 2u) {
phi_8151_ = _e23805;
} else {
phi_8151_ = select(_e23811, _e23808, (_e23706 == 3u));
}
let _e23818 = phi_8151_;
phi_8152_ = _e23818;
}
let _e23820 = phi_8152_;
phi_8153_ = _e23820;
}
let _e23822 = phi_8153_;
local_194 = (((bitcast<i32>(_e23822) + _e23796.member_1) * _e23802) + _e23796.member);
let _e23827 = local_194;
let _e23829 = (bitcast<i32>(_e280) - 1i);
let _e23831 = select(_e23829, _e23827, (_e23827 < _e23829));
let _e23836 = global_6.member[bitcast<u32>(select(0i, _e23831, (_e23831 > 0i)))];
let _e23841 = (((((select(_e23786, _e23790, _e471) + 0.5f) / _e22936) * 2f) - 1f) * _e22944);
let _e23846 = ((1f - (((select(_e23790, _e23786, _e471) + 0.5f) / _e22937) * 2f)) * _e22952);
let _e23853 = ((_e22955.member * _e23841) + (_e22963.member * _e23846));
let _e23854 = ((_e22955.member_1 * _e23841) + (_e22963.member_1 * _e23846));
let _e23855 = ((_e22955.member_2 * _e23841) + (_e22963.member_2 * _e23846));
let _e23859 = select((_e22978.member + _e23853), _e22978.member, _e22976);
let _e23860 = select((_e22978.member_1 + _e23854), _e22978.member_1, _e22976);
let _e23861 = select((_e22978.member_2 + _e23855), _e22978.member_2, _e22976);
let _e23872 = (((_e23859 * _e23859) + (_e23860 * _e23860)) + (_e23861 * _e23861));
let _e23876 = (1f / sqrt(select(0f, _e23872, (_e23872 > 0f))));
let _e23877 = (_e23859 * _e23876);
let _e23878 = (_e23860 * _e23876);
let _e23879 = (_e23861 * _e23876);
let _e23880 = (_e593 - select(_e22989.member, (_e22989.member + _e23853), _e22976));
let _e23881 = (_e605 - select(_e22989.member_1, (_e22989.member_1 + _e23854), _e22976));
let _e23882 = (_e618 - select(_e22989.member_2, (_e22989.member_2 + _e23855), _e22976));
let _e23887 = (((_e23880 * _e23877) + (_e23881 * _e23878)) + (_e23882 * _e23879));
let _e23892 = (((_e23880 * _e631) + (_e23881 * _e644)) + (_e23882 * _e657));
let _e23897 = (((_e23877 * _e631) + (_e23878 * _e644)) + (_e23879 * _e657));
let _e23900 = ((_e23878 * _e657) - (_e23879 * _e644));
let _e23903 = ((_e23879 * _e631) - (_e23877 * _e657));
let _e23906 = ((_e23877 * _e644) - (_e23878 * _e631));
let _e23911 = (((_e23900 * _e23900) + (_e23903 * _e23903)) + (_e23906 * _e23906));
let _e23914 = (1f / select(1e-9f, _e23911, (_e23911 > 1e-9f)));
let _e23917 = ((_e23887 - (_e23897 * _e23892)) * _e23914);
let _e23920 = (((_e23897 * _e23887) - _e23892) * _e23914);
let _e23926 = select(0f, _e23917, (((_e23920 >= 0f) && (_e23920 < _e709)) && (_e23917 > 0f)));
let _e23928 = (_e23776 << bitcast<u32>(_e23707));
let _e23940 = (_e23748 + 1i);
let _e23943 = select(_e23940, 0i, (_e23940 < 0i));
let _e23944 = (_e23943 >= _e23723.member);
if _e23944 {
phi_9137_ = (_e23723.member - 1i);
} else {
phi_9137_ = _e23943;
}
let _e23947 = phi_9137_;
if _e23779 {
phi_9148_ = (_e23723.member_1 - 1i);
} else {
phi_9148_ = _e23778;
}
let _e23950 = phi_9148_;
let _e23954 = (((f32(_e23947) + 0.5f) * _e23728) - 0.5f);
let _e23958 = (((f32(_e23950) + 0.5f) * _e23728) - 0.5f);
if _e471 {
phi_9176_ = type_26(_e23950, _e23947);
} else {
phi_9176_ = type_26(_e23947, _e23950);
}
let _e23964 = phi_9176_;
if _e23812 {
phi_9227_ = 0u;
} else {
if (_e23706 == 1u) {
phi_9226_ = 0u;
} else {
if (_e23706 == 2u) {
phi_9225_ = _e23805;
} else {
phi_9225_ = select(_e23811, _e23808, (_e23706 == 3u));
}
let _e23972 = phi_9225_;
phi_9226_ = _e23972;
}
let _e23974 = phi_9226_;
phi_9227_ = _e23974;
}
let _e23976 = phi_9227_;
local_192 = (((bitcast<i32>(_e23976) + _e23964.member_1) * _e23802) + _e23964.member);
let _e23981 = local_192;
let _e23983 = select(_e23829, _e23981, (_e23981 < _e23829));
let _e23988 = global_6.member[bitcast<u32>(select(0i, _e23983, (_e23983 > 0i)))];
let _e23993 = (((((select(_e23954, _e23958, _e471) + 0.5f) / _e22936) * 2f) - 1f) * _e22944);
let _e23998 = ((1f - (((select(_e23958, _e23954, _e471) + 0.5f) / _e22937) * 2f)) * _e22952);
let _e24005 = ((_e22955.member * _e23993) + (_e22963.member * _e23998));
let _e24006 = ((_e22955.member_1 * _e23993) + (_e22963.member_1 * _e23998));
let _e24007 = ((_e22955.member_2 * _e23993) + (_e22963.member_2 * _e23998));
let _e24011 = select((_e22978.member + _e24005), _e22978.member, _e22976);
let _e24012 = select((_e22978.member_1 + _e24006), _e22978.member_1, _e22976);
let _e24013 = select((_e22978.member_2 + _e24007), _e22978.member_2, _e22976);
let _e24024 = (((_e24011 * _e24011) + (_e24012 * _e24012)) + (_e24013 * _e24013));
let _e24028 = (1f / sqrt(select(0f, _e24024, (_e24024 > 0f))));
let _e24029 = (_e24011 * _e24028);
let _e24030 = (_e24012 * _e24028);
let _e24031 = (_e24013 * _e24028);
let _e24032 = (_e593 - select(_e22989.member, (_e22989.member + _e24005), _e22976));
let _e24033 = (_e605 - select(_e22989.member_1, (_e22989.member_1 + _e24006), _e22976));
let _e24034 = (_e618 - select(_e22989.member_2, (_e22989.member_2 + _e24007), _e22976));
let _e24039 = (((_e24032 * _e24029) + (_e24033 * _e24030)) + (_e24034 * _e24031));
let _e24044 = (((_e24032 * _e631) + (_e24033 * _e644)) + (_e24034 * _e657));
let _e24049 = (((_e24029 * _e631) + (_e24030 * _e644)) + (_e24031 * _e657));
let _e24052 = ((_e24030 * _e657) - (_e24031 * _e644));
let _e24055 = ((_e24031 * _e631) - (_e24029 * _e657));
let _e24058 = ((_e24029 * _e644) - (_e24030 * _e631));
let _e24063 = (((_e24052 * _e24052) + (_e24055 * _e24055)) + (_e24058 * _e24058));
let _e24066 = (1f / select(1e-9f, _e24063, (_e24063 > 1e-9f)));
let _e24069 = ((_e24039 - (_e24049 * _e24044)) * _e24066);
let _e24072 = (((_e24049 * _e24039) - _e24044) * _e24066);
let _e24078 = select(0f, _e24069, (((_e24072 >= 0f) && (_e24072 < _e709)) && (_e24069 > 0f)));
let _e24080 = (_e23947 << bitcast<u32>(_e23707));
let _e24092 = (_e23763 + 1i);
if _e23773 {
phi_10211_ = (_e23723.member - 1i);
} else {
phi_10211_ = _e23772;
}
let _e24096 = phi_10211_;
let _e24098 = select(_e24092, 0i, (_e24092 < 0i));
let _e24099 = (_e24098 >= _e23723.member_1);
if _e24099 {
phi_10222_ = (_e23723.member_1 - 1i);
} else {
phi_10222_ = _e24098;
}
let _e24102 = phi_10222_;
let _e24106 = (((f32(_e24096) + 0.5f) * _e23728) - 0.5f);
let _e24110 = (((f32(_e24102) + 0.5f) * _e23728) - 0.5f);
if _e471 {
phi_10250_ = type_26(_e24102, _e24096);
} else {
phi_10250_ = type_26(_e24096, _e24102);
}
let _e24116 = phi_10250_;
if _e23812 {
phi_10301_ = 0u;
} else {
if (_e23706 == 1u) {
phi_10300_ = 0u;
} else {
if (_e23706 == 2u) {
phi_10299_ = _e23805;
} else {
phi_10299_ = select(_e23811, _e23808, (_e23706 == 3u));
}
let _e24124 = phi_10299_;
phi_10300_ = _e24124;
}
let _e24126 = phi_10300_;
phi_10301_ = _e24126;
}
let _e24128 = phi_10301_;
local_190 = (((bitcast<i32>(_e24128) + _e24116.member_1) * _e23802) + _e24116.member);
let _e24133 = local_190;
let _e24135 = select(_e23829, _e24133, (_e24133 < _e23829));
let _e24140 = global_6.member[bitcast<u32>(select(0i, _e24135, (_e24135 > 0i)))];
let _e24145 = (((((select(_e24106, _e24110, _e471) + 0.5f) / _e22936) * 2f) - 1f) * _e22944);
let _e24150 = ((1f - (((select(_e24110, _e24106, _e471) + 0.5f) / _e22937) * 2f)) * _e22952);
let _e24157 = ((_e22955.member * _e24145) + (_e22963.member * _e24150));
let _e24158 = ((_e22955.member_1 * _e24145) + (_e22963.member_1 * _e24150));
let _e24159 = ((_e22955.member_2 * _e24145) + (_e22963.member_2 * _e24150));
let _e24163 = select((_e22978.member + _e24157), _e22978.member, _e22976);
let _e24164 = select((_e22978.member_1 + _e24158), _e22978.member_1, _e22976);
let _e24165 = select((_e22978.member_2 + _e24159), _e22978.member_2, _e22976);
let _e24176 = (((_e24163 * _e24163) + (_e24164 * _e24164)) + (_e24165 * _e24165));
let _e24180 = (1f / sqrt(select(0f, _e24176, (_e24176 > 0f))));
let _e24181 = (_e24163 * _e24180);
let _e24182 = (_e24164 * _e24180);
let _e24183 = (_e24165 * _e24180);
let _e24184 = (_e593 - select(_e22989.member, (_e22989.member + _e24157), _e22976));
let _e24185 = (_e605 - select(_e22989.member_1, (_e22989.member_1 + _e24158), _e22976));
let _e24186 = (_e618 - select(_e22989.member_2, (_e22989.member_2 + _e24159), _e22976));
let _e24191 = (((_e24184 * _e24181) + (_e24185 * _e24182)) + (_e24186 * _e24183));
let _e24196 = (((_e24184 * _e631) + (_e24185 * _e644)) + (_e24186 * _e657));
let _e24201 = (((_e24181 * _e631) + (_e24182 * _e644)) + (_e24183 * _e657));
let _e24204 = ((_e24182 * _e657) - (_e24183 * _e644));
let _e24207 = ((_e24183 * _e631) - (_e24181 * _e657));
let _e24210 = ((_e24181 * _e644) - (_e24182 * _e631));
let _e24215 = (((_e24204 * _e24204) + (_e24207 * _e24207)) + (_e24210 * _e24210));
let _e24218 = (1f / select(1e-9f, _e24215, (_e24215 > 1e-9f)));
let _e24221 = ((_e24191 - (_e24201 * _e24196)) * _e24218);
let _e24224 = (((_e24201 * _e24191) - _e24196) * _e24218);
let _e24230 = select(0f, _e24221, (((_e24224 >= 0f) && (_e24224 < _e709)) && (_e24221 > 0f)));
let _e24232 = (_e24096 << bitcast<u32>(_e23707));
if _e23944 {
phi_11285_ = (_e23723.member - 1i);
} else {
phi_11285_ = _e23943;
}
let _e24247 = phi_11285_;
if _e24099 {
phi_11296_ = (_e23723.member_1 - 1i);
} else {
phi_11296_ = _e24098;
}
let _e24250 = phi_11296_;
let _e24254 = (((f32(_e24247) + 0.5f) * _e23728) - 0.5f);
let _e24258 = (((f32(_e24250) + 0.5f) * _e23728) - 0.5f);
if _e471 {
phi_11324_ = type_26(_e24250, _e24247);
} else {
phi_11324_ = type_26(_e24247, _e24250);
}
let _e24264 = phi_11324_;
if _e23812 {
phi_11375_ = 0u;
} else {
if (_e23706 == 1u) {
phi_11374_ = 0u;
} else {
if (_e23706 == 2u) {
phi_11373_ = _e23805;
} else {
phi_11373_ = select(_e23811, _e23808, (_e23706 == 3u));
}
let _e24272 = phi_11373_;
phi_11374_ = _e24272;
}
let _e24274 = phi_11374_;
phi_11375_ = _e24274;
}
let _e24276 = phi_11375_;
local_188 = (((bitcast<i32>(_e24276) + _e24264.member_1) * _e23802) + _e24264.member);
let _e24281 = local_188;
let _e24283 = select(_e23829, _e24281, (_e24281 < _e23829));
let _e24288 = global_6.member[bitcast<u32>(select(0i, _e24283, (_e24283 > 0i)))];
let _e24293 = (((((select(_e24254, _e24258, _e471) + 0.5f) / _e22936) * 2f) - 1f) * _e22944);
let _e24298 = ((1f - (((select(_e24258, _e24254, _e471) + 0.5f) / _e22937) * 2f)) * _e22952);
let _e24305 = ((_e22955.member * _e24293) + (_e22963.member * _e24298));
let _e24306 = ((_e22955.member_1 * _e24293) + (_e22963.member_1 * _e24298));
let _e24307 = ((_e22955.member_2 * _e24293) + (_e22963.member_2 * _e24298));
let _e24311 = select((_e22978.member + _e24305), _e22978.member, _e22976);
let _e24312 = select((_e22978.member_1 + _e24306), _e22978.member_1, _e22976);
let _e24313 = select((_e22978.member_2 + _e24307), _e22978.member_2, _e22976);
let _e24324 = (((_e24311 * _e24311) + (_e24312 * _e24312)) + (_e24313 * _e24313));
let _e24328 = (1f / sqrt(select(0f, _e24324, (_e24324 > 0f))));
let _e24329 = (_e24311 * _e24328);
let _e24330 = (_e24312 * _e24328);
let _e24331 = (_e24313 * _e24328);
let _e24332 = (_e593 - select(_e22989.member, (_e22989.member + _e24305), _e22976));
let _e24333 = (_e605 - select(_e22989.member_1, (_e22989.member_1 + _e24306), _e22976));
let _e24334 = (_e618 - select(_e22989.member_2, (_e22989.member_2 + _e24307), _e22976));
let _e24339 = (((_e24332 * _e24329) + (_e24333 * _e24330)) + (_e24334 * _e24331));
let _e24344 = (((_e24332 * _e631) + (_e24333 * _e644)) + (_e24334 * _e657));
let _e24349 = (((_e24329 * _e631) + (_e24330 * _e644)) + (_e24331 * _e657));
let _e24352 = ((_e24330 * _e657) - (_e24331 * _e644));
let _e24355 = ((_e24331 * _e631) - (_e24329 * _e657));
let _e24358 = ((_e24329 * _e644) - (_e24330 * _e631));
let _e24363 = (((_e24352 * _e24352) + (_e24355 * _e24355)) + (_e24358 * _e24358));
let _e24366 = (1f / select(1e-9f, _e24363, (_e24363 > 1e-9f)));
let _e24369 = ((_e24339 - (_e24349 * _e24344)) * _e24366);
let _e24372 = (((_e24349 * _e24339) - _e24344) * _e24366);
let _e24378 = select(0f, _e24369, (((_e24372 >= 0f) && (_e24372 < _e709)) && (_e24369 > 0f)));
let _e24380 = (_e24247 << bitcast<u32>(_e23707));
let _e24392 = select(((((1f - select(0f, (_e23768 * _e23769), (((select(select(_e784, _e941, (_e23928 >= _e710)), _e863, (_e23928 < _e316)) == _e23706) && (_e23926 > 0f)) && (_e23926 < _e23836)))) - select(0f, (_e23765 * _e23769), (((select(select(_e784, _e941, (_e24080 >= _e710)), _e863, (_e24080 < _e316)) == _e23706) && (_e24078 > 0f)) && (_e24078 < _e23988)))) - select(0f, (_e23768 * _e23767), (((select(select(_e784, _e941, (_e24232 >= _e710)), _e863, (_e24232 < _e316)) == _e23706) && (_e24230 > 0f)) && (_e24230 < _e24140)))) - select(0f, (_e23765 * _e23767), (((select(select(_e784, _e941, (_e24380 >= _e710)), _e863, (_e24380 < _e316)) == _e23706) && (_e24378 > 0f)) && (_e24378 < _e24288)))), 1f, _e23812);
if _e471 {
phi_12368_ = type_26(_e22841, _e22749);
} else {
phi_12368_ = type_26(_e22749, _e22841);
}
let _e24407 = phi_12368_;
let _e24410 = (_e22842 && (((_e23704 > 0f) && (_e23704 < _e22932)) && (bitcast<f32>((bitcast<u32>(_e24392) & 2147483647u)) > 1e-6f)));
let _e24413 = global_1.member.member_18.member;
let _e24414 = (((select(_e22867, (1f - _e22867), (_e22852 >= 0f)) - select(_e22886, (1f - _e22886), (_e22871 >= 0f))) * (1f / _e22849)) * _e24413);
let _e24418 = select(0f, (((((_e670 * _e23691.member) * ((1f + (_e23572 * (1f + (_e23572 * (0.5f + (_e23572 * (0.16666667f + (_e23572 * (0.041666668f + (_e23572 * (0.008333334f + (_e23572 * (0.001388889f + (_e23572 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23567 + 127i)) << bitcast<u32>(23i))))) * _e23394) * _e24392) * _e24414), _e24410);
let _e24419 = select(0f, (((((_e683 * _e23691.member_1) * ((1f + (_e23620 * (1f + (_e23620 * (0.5f + (_e23620 * (0.16666667f + (_e23620 * (0.041666668f + (_e23620 * (0.008333334f + (_e23620 * (0.001388889f + (_e23620 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23615 + 127i)) << bitcast<u32>(23i))))) * _e23394) * _e24392) * _e24414), _e24410);
let _e24420 = select(0f, (((((_e696 * _e23691.member_2) * ((1f + (_e23668 * (1f + (_e23668 * (0.5f + (_e23668 * (0.16666667f + (_e23668 * (0.041666668f + (_e23668 * (0.008333334f + (_e23668 * (0.001388889f + (_e23668 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23663 + 127i)) << bitcast<u32>(23i))))) * _e23394) * _e24392) * _e24414), _e24410);
let _e24424 = (bitcast<f32>((bitcast<u32>(_e24418) & 2147483647u)) >= 1073741800f);
let _e24425 = (1f / 1048576f);
let _e24428 = ((_e24418 * select(1f, _e24425, _e24424)) + 0.5f);
let _e24430 = select(-1073741800f, _e24428, (_e24428 > -1073741800f));
let _e24432 = select(1073741800f, _e24430, (_e24430 < 1073741800f));
let _e24439 = select(0i, select(select(i32(_e24432), i32(-2147483648), (_e24432 < -2147483600f)), 2147483647i, (_e24432 > 2147483500f)), (_e24432 == _e24432));
let _e24443 = (_e24439 - select(0i, 1i, (_e24432 < f32(_e24439))));
let _e24444 = select(0i, 20i, _e24424);
let _e24448 = (bitcast<u32>(_e24443) << bitcast<u32>((_e24444 & 31i)));
let _e24455 = bitcast<u32>(((_e24443 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e24444) & 31i))));
let _e24459 = (bitcast<f32>((bitcast<u32>(_e24419) & 2147483647u)) >= 1073741800f);
let _e24462 = ((_e24419 * select(1f, _e24425, _e24459)) + 0.5f);
let _e24464 = select(-1073741800f, _e24462, (_e24462 > -1073741800f));
let _e24466 = select(1073741800f, _e24464, (_e24464 < 1073741800f));
let _e24473 = select(0i, select(select(i32(_e24466), i32(-2147483648), (_e24466 < -2147483600f)), 2147483647i, (_e24466 > 2147483500f)), (_e24466 == _e24466));
let _e24477 = (_e24473 - select(0i, 1i, (_e24466 < f32(_e24473))));
let _e24478 = select(0i, 20i, _e24459);
let _e24482 = (bitcast<u32>(_e24477) << bitcast<u32>((_e24478 & 31i)));
let _e24489 = bitcast<u32>(((_e24477 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e24478) & 31i))));
let _e24493 = (bitcast<f32>((bitcast<u32>(_e24420) & 2147483647u)) >= 1073741800f);
let _e24496 = ((_e24420 * select(1f, _e24425, _e24493)) + 0.5f);
let _e24498 = select(-1073741800f, _e24496, (_e24496 > -1073741800f));
let _e24500 = select(1073741800f, _e24498, (_e24498 < 1073741800f));
let _e24507 = select(0i, select(select(i32(_e24500), i32(-2147483648), (_e24500 < -2147483600f)), 2147483647i, (_e24500 > 2147483500f)), (_e24500 == _e24500));
let _e24511 = (_e24507 - select(0i, 1i, (_e24500 < f32(_e24507))));
let _e24512 = select(0i, 20i, _e24493);
let _e24516 = (bitcast<u32>(_e24511) << bitcast<u32>((_e24512 & 31i)));
let _e24523 = bitcast<u32>(((_e24511 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e24512) & 31i))));
let _e24528 = bitcast<i32>(bitcast<u32>((((_e24407.member_1 * _e11931) + _e24407.member) * 6i)));
if ((_e24448 | _e24455) == 0u) {
} else {
let _e24531 = bitcast<u32>(_e24528);
if (_e24531 < _e288) {
let _e24535 = atomicAdd((&global_8.member[_e24531]), _e24448);
phi_12601_ = _e24535;
} else {
phi_12601_ = 0u;
}
let _e24537 = phi_12601_;
let _e24541 = (_e24455 + select(0u, 1u, ((_e24537 + _e24448) < _e24448)));
if (_e24541 == 0u) {
} else {
let _e24543 = (_e24531 + 1u);
if (_e24543 < _e288) {
let _e24547 = atomicAdd((&global_8.member[_e24543]), _e24541);
}
}
}
if ((_e24482 | _e24489) == 0u) {
} else {
let _e24551 = bitcast<u32>((_e24528 + 2i));
if (_e24551 < _e288) {
let _e24555 = atomicAdd((&global_8.member[_e24551]), _e24482);
phi_12631_ = _e24555;
} else {
phi_12631_ = 0u;
}
let _e24557 = phi_12631_;
let _e24561 = (_e24489 + select(0u, 1u, ((_e24557 + _e24482) < _e24482)));
if (_e24561 == 0u) {
} else {
let _e24563 = (_e24551 + 1u);
if (_e24563 < _e288) {
let _e24567 = atomicAdd((&global_8.member[_e24563]), _e24561);
}
}
}
if ((_e24516 | _e24523) == 0u) {
} else {
let _e24571 = bitcast<u32>((_e24528 + 4i));
if (_e24571 < _e288) {
let _e24575 = atomicAdd((&global_8.member[_e24571]), _e24516);
phi_12661_ = _e24575;
} else {
phi_12661_ = 0u;
}
let _e24577 = phi_12661_;
let _e24581 = (_e24523 + select(0u, 1u, ((_e24577 + _e24516) < _e24516)));
if (_e24581 == 0u) {
} else {
let _e24583 = (_e24571 + 1u);
if (_e24583 < _e288) {
let _e24587 = atomicAdd((&global_8.member[_e24583]), _e24581);
}
}
}
phi_6574_ = (_e22839 + 1i);
} else {
phi_6574_ = i32();
}
let _e24590 = phi_6574_;
continue;
continuing {
phi_6573_ = _e24590;
break if !(_e22842);
}
}
phi_6420_ = (_e22746 + 1i);
} else {
phi_6420_ = i32();
}
let _e24594 = phi_6420_;
continue;
continuing {
phi_6419_ = _e24594;
break if !(_e22747);
}
}
} else {
phi_12706_ = 0i;
loop {
let _e19556 = phi_12706_;
let _e19557 = (_e19556 < 16i);
if _e19557 {
let _e19559 = (_e11976 + (_e19556 & 15i));
let _e19561 = (f32(_e19559) + 0.5f);
let _e19563 = ((_e19561 * 1f) - 0.5f);
let _e19567 = (-(((_e434 * _e19563) + _e460)) / _e447);
let _e19574 = bitcast<f32>((bitcast<u32>(((_e484 * _e19563) + ((_e497 * _e19567) + _e510))) & 2147483647u));
let _e19581 = bitcast<f32>((bitcast<u32>(((_e523 * _e19563) + ((_e536 * _e19567) + _e549))) & 2147483647u));
let _e19585 = (((0.5f * (_e19574 + _e19581)) / _e552) + _e735);
let _e19586 = (1f / 1f);
let _e19594 = ((((_e19567 + _e19585) + 0.5f) * _e19586) - 0.5f);
let _e19595 = f32(_e11981);
let _e19596 = (0f - 1f);
let _e19598 = select(_e19596, _e19594, (_e19594 > _e19596));
let _e19600 = select(_e19595, _e19598, (_e19598 < _e19595));
let _e19607 = select(0i, select(select(i32(_e19600), i32(-2147483648), (_e19600 < -2147483600f)), 2147483647i, (_e19600 > 2147483500f)), (_e19600 == _e19600));
let _e19612 = (((((_e19567 - _e19585) + 0.5f) * _e19586) - 0.5f) + 1f);
let _e19613 = (_e19595 + 1f);
let _e19615 = select(0f, _e19612, (_e19612 > 0f));
let _e19617 = select(_e19613, _e19615, (_e19615 < _e19613));
let _e19624 = select(0i, select(select(i32(_e19617), i32(-2147483648), (_e19617 < -2147483600f)), 2147483647i, (_e19617 > 2147483500f)), (_e19617 == _e19617));
let _e19635 = ((1e-4f * 1f) * _e552);
let _e19637 = select(_e19581, _e19574, (_e19574 > _e19581));
let _e19639 = select(_e19635, _e19637, (_e19637 > _e19635));
let _e19641 = select(_e19581, _e19574, (_e19574 < _e19581));
let _e19643 = select(_e19635, _e19641, (_e19641 > _e19635));
let _e19645 = (0.5f * (_e19639 + _e19643));
let _e19646 = (0.5f / _e19643);
let _e19647 = (1f / _e19639);
phi_12860_ = 0i;
loop {
let _e19649 = phi_12860_;
let _e19651 = (((_e19624 - select(0i, 1i, (_e19617 < f32(_e19624)))) + (_e19556 >> bitcast<u32>(4u))) + bitcast<i32>(_e19649));
let _e19652 = (_e19651 <= select(-1i, (_e19607 - select(0i, 1i, (_e19600 < f32(_e19607)))), (_e19559 <= _e11980)));
if _e19652 {
let _e19654 = (f32(_e19651) + 0.5f);
let _e19658 = ((((_e19654 * 1f) - 0.5f) - _e19567) * _e552);
let _e19659 = (_e552 * 1f);
let _e19661 = (0.5f * _e19659);
let _e19662 = (_e19658 + _e19661);
let _e19663 = -(_e19662);
let _e19666 = (_e19645 - select(_e19663, _e19662, (_e19662 > _e19663)));
let _e19668 = select(0f, _e19666, (_e19666 > 0f));
let _e19670 = select(_e19643, _e19668, (_e19668 < _e19643));
let _e19673 = (_e19666 - _e19643);
let _e19677 = (((_e19670 * (_e19670 * _e19646)) + select(0f, _e19673, (_e19673 > 0f))) * _e19647);
let _e19681 = (_e19658 - _e19661);
let _e19682 = -(_e19681);
let _e19685 = (_e19645 - select(_e19682, _e19681, (_e19681 > _e19682)));
let _e19687 = select(0f, _e19685, (_e19685 > 0f));
let _e19689 = select(_e19643, _e19687, (_e19687 < _e19643));
let _e19692 = (_e19685 - _e19643);
let _e19696 = (((_e19689 * (_e19689 * _e19646)) + select(0f, _e19692, (_e19692 > 0f))) * _e19647);
if _e471 {
phi_12965_ = type_26(_e19651, _e19559);
} else {
phi_12965_ = type_26(_e19559, _e19651);
}
let _e19705 = phi_12965_;
let _e19709 = bitcast<i32>((_e11927 * _e11930));
local_186 = _e19709;
local_187 = ((_e19705.member_1 * _e11931) + _e19705.member);
let _e19712 = local_186;
let _e19713 = local_187;
let _e19714 = (_e19712 + _e19713);
let _e19716 = (bitcast<i32>(_e277) - 1i);
let _e19718 = select(_e19716, _e19714, (_e19714 < _e19716));
let _e19723 = global_5.member[bitcast<u32>(select(0i, _e19718, (_e19718 > 0i)))];
let _e19724 = local_186;
let _e19726 = local_187;
let _e19727 = ((2i * _e19724) + _e19726);
let _e19729 = select(_e19716, _e19727, (_e19727 < _e19716));
let _e19734 = global_5.member[bitcast<u32>(select(0i, _e19729, (_e19729 > 0i)))];
let _e19735 = local_187;
let _e19737 = select(_e19716, _e19735, (_e19735 < _e19716));
let _e19742 = global_5.member[bitcast<u32>(select(0i, _e19737, (_e19737 > 0i)))];
let _e19743 = local_187;
let _e19746 = f32(_e11931);
let _e19747 = f32(_e11932);
let _e19754 = global_1.member.member_2.member;
let _e19755 = (((((f32(_e19705.member) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e19762 = global_1.member.member_2.member_1;
let _e19763 = ((1f - (((f32(_e19705.member_1) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e19765 = global_1.member.member_3;
let _e19773 = global_1.member.member_4;
let _e19780 = ((_e19765.member * _e19755) + (_e19773.member * _e19763));
let _e19781 = ((_e19765.member_1 * _e19755) + (_e19773.member_1 * _e19763));
let _e19782 = ((_e19765.member_2 * _e19755) + (_e19773.member_2 * _e19763));
let _e19785 = global_1.member.member_2.member_3;
let _e19786 = (_e19785 != 0u);
let _e19788 = global_1.member.member_5;
let _e19795 = select((_e19788.member + _e19780), _e19788.member, _e19786);
let _e19796 = select((_e19788.member_1 + _e19781), _e19788.member_1, _e19786);
let _e19797 = select((_e19788.member_2 + _e19782), _e19788.member_2, _e19786);
let _e19799 = global_1.member.member_6;
let _e19806 = select(_e19799.member, (_e19799.member + _e19780), _e19786);
let _e19807 = select(_e19799.member_1, (_e19799.member_1 + _e19781), _e19786);
let _e19808 = select(_e19799.member_2, (_e19799.member_2 + _e19782), _e19786);
let _e19813 = (((_e19795 * _e19795) + (_e19796 * _e19796)) + (_e19797 * _e19797));
let _e19816 = sqrt(select(0f, _e19813, (_e19813 > 0f)));
let _e19817 = (1f / _e19816);
let _e19818 = (_e19795 * _e19817);
let _e19819 = (_e19796 * _e19817);
let _e19820 = (_e19797 * _e19817);
let _e19821 = (_e593 - _e19806);
let _e19822 = (_e605 - _e19807);
let _e19823 = (_e618 - _e19808);
let _e19828 = (((_e19821 * _e19818) + (_e19822 * _e19819)) + (_e19823 * _e19820));
let _e19833 = (((_e19821 * _e631) + (_e19822 * _e644)) + (_e19823 * _e657));
let _e19838 = (((_e19818 * _e631) + (_e19819 * _e644)) + (_e19820 * _e657));
let _e19841 = ((_e19819 * _e657) - (_e19820 * _e644));
let _e19844 = ((_e19820 * _e631) - (_e19818 * _e657));
let _e19847 = ((_e19818 * _e644) - (_e19819 * _e631));
let _e19852 = (((_e19841 * _e19841) + (_e19844 * _e19844)) + (_e19847 * _e19847));
let _e19855 = (1f / select(1e-9f, _e19852, (_e19852 > 1e-9f)));
let _e19858 = ((_e19828 - (_e19838 * _e19833)) * _e19855);
let _e19861 = (((_e19838 * _e19828) - _e19833) * _e19855);
let _e19867 = -(_e19838);
let _e19870 = global_1.member.member_13.member_2;
let _e19871 = (_e19870 * _e19870);
let _e19875 = ((1f + _e19871) - ((2f * _e19870) * _e19867));
let _e19877 = select(1e-9f, _e19875, (_e19875 > 1e-9f));
let _e19889 = global_1.member.member_13.member_3;
if (_e19889 == 2u) {
let _e19894 = (0.5f - (0.5f * _e19867));
let _e19896 = select(0f, _e19894, (_e19894 > 0f));
let _e19900 = (sqrt(select(0f, _e19896, (_e19896 > 0f))) * 255f);
let _e19901 = (255f - 1f);
let _e19903 = select(0f, _e19900, (_e19900 > 0f));
let _e19905 = select(_e19901, _e19903, (_e19903 < _e19901));
let _e19912 = select(0i, select(select(i32(_e19905), i32(-2147483648), (_e19905 < -2147483600f)), 2147483647i, (_e19905 > 2147483500f)), (_e19905 == _e19905));
let _e19916 = (_e19912 - select(0i, 1i, (_e19905 < f32(_e19912))));
let _e19919 = global_1.member.member_13.member_11;
let _e19920 = bitcast<i32>(_e19919);
let _e19921 = (_e19920 + _e19916);
let _e19923 = (bitcast<i32>(_e283) - 1i);
let _e19925 = select(_e19923, _e19921, (_e19921 < _e19923));
let _e19930 = global_2.member[bitcast<u32>(select(0i, _e19925, (_e19925 > 0i)))];
let _e19932 = (_e19920 + (_e19916 + 1i));
let _e19934 = select(_e19923, _e19932, (_e19932 < _e19923));
let _e19939 = global_2.member[bitcast<u32>(select(0i, _e19934, (_e19934 > 0i)))];
phi_13392_ = (_e19930 + ((_e19939 - _e19930) * (_e19900 - f32(_e19916))));
} else {
phi_13392_ = select(((1f - _e19871) / (_e19877 * sqrt(select(0f, _e19877, (_e19877 > 0f))))), (0.75f * (1f + (_e19867 * _e19867))), (_e19889 == 1u));
}
let _e19946 = phi_13392_;
let _e19958 = global_1.member.member_13.member_7;
let _e19959 = bitcast<i32>(_e19958);
let _e19962 = global_1.member.member_13.member_8;
let _e19963 = bitcast<i32>(_e19962);
let _e19966 = global_1.member.member_13.member_9;
let _e19967 = bitcast<i32>(_e19966);
let _e19970 = global_1.member.member_13.member_4;
let _e19976 = global_1.member.member_13.member_5;
let _e19980 = f32(_e19959);
let _e19985 = (((((_e19806 + (_e19818 * _e19858)) - _e19970.member) / (_e19976.member - _e19970.member)) * _e19980) - 0.5f);
let _e19986 = (_e19980 - 1f);
let _e19988 = select(0f, _e19985, (_e19985 > 0f));
let _e19990 = select(_e19986, _e19988, (_e19988 < _e19986));
let _e19991 = f32(_e19963);
let _e19996 = (((((_e19807 + (_e19819 * _e19858)) - _e19970.member_1) / (_e19976.member_1 - _e19970.member_1)) * _e19991) - 0.5f);
let _e19997 = (_e19991 - 1f);
let _e19999 = select(0f, _e19996, (_e19996 > 0f));
let _e20001 = select(_e19997, _e19999, (_e19999 < _e19997));
let _e20002 = f32(_e19967);
let _e20007 = (((((_e19808 + (_e19820 * _e19858)) - _e19970.member_2) / (_e19976.member_2 - _e19970.member_2)) * _e20002) - 0.5f);
let _e20008 = (_e20002 - 1f);
let _e20010 = select(0f, _e20007, (_e20007 > 0f));
let _e20012 = select(_e20008, _e20010, (_e20010 < _e20008));
let _e20014 = select(0f, _e19990, (_e19990 > 0f));
let _e20016 = select(1e6f, _e20014, (_e20014 < 1e6f));
let _e20023 = select(0i, select(select(i32(_e20016), i32(-2147483648), (_e20016 < -2147483600f)), 2147483647i, (_e20016 > 2147483500f)), (_e20016 == _e20016));
let _e20027 = (_e20023 - select(0i, 1i, (_e20016 < f32(_e20023))));
let _e20029 = select(0f, _e20001, (_e20001 > 0f));
let _e20031 = select(1e6f, _e20029, (_e20029 < 1e6f));
let _e20038 = select(0i, select(select(i32(_e20031), i32(-2147483648), (_e20031 < -2147483600f)), 2147483647i, (_e20031 > 2147483500f)), (_e20031 == _e20031));
let _e20042 = (_e20038 - select(0i, 1i, (_e20031 < f32(_e20038))));
let _e20044 = select(0f, _e20012, (_e20012 > 0f));
let _e20046 = select(1e6f, _e20044, (_e20044 < 1e6f));
let _e20053 = select(0i, select(select(i32(_e20046), i32(-2147483648), (_e20046 < -2147483600f)), 2147483647i, (_e20046 > 2147483500f)), (_e20046 == _e20046));
let _e20057 = (_e20053 - select(0i, 1i, (_e20046 < f32(_e20053))));
let _e20061 = (_e20001 - f32(_e20042));
let _e20063 = (_e20012 - f32(_e20057));
local_184 = (_e19990 - f32(_e20027));
let _e20064 = (_e20027 + 1i);
let _e20066 = select(_e20064, 0i, (_e20064 < 0i));
if (_e20066 >= _e19959) {
phi_13524_ = (_e19959 - 1i);
} else {
phi_13524_ = _e20066;
}
let _e20070 = phi_13524_;
local_185 = (_e20070 - _e20027);
let _e20072 = (_e20042 + 1i);
let _e20074 = select(_e20072, 0i, (_e20072 < 0i));
if (_e20074 >= _e19963) {
phi_13537_ = (_e19963 - 1i);
} else {
phi_13537_ = _e20074;
}
let _e20078 = phi_13537_;
let _e20080 = ((_e20078 - _e20042) * _e19959);
let _e20081 = (_e20057 + 1i);
let _e20083 = select(_e20081, 0i, (_e20081 < 0i));
if (_e20083 >= _e19967) {
phi_13551_ = (_e19967 - 1i);
} else {
phi_13551_ = _e20083;
}
let _e20087 = phi_13551_;
let _e20093 = global_1.member.member_13.member_10;
let _e20099 = ((bitcast<i32>(_e20093) + (((_e20057 * _e19963) + _e20042) * _e19959)) + _e20027);
let _e20101 = (bitcast<i32>(_e283) - 1i);
let _e20103 = select(_e20101, _e20099, (_e20099 < _e20101));
let _e20108 = global_2.member[bitcast<u32>(select(0i, _e20103, (_e20103 > 0i)))];
let _e20109 = local_184;
let _e20112 = local_185;
let _e20113 = (_e20099 + _e20112);
let _e20115 = select(_e20101, _e20113, (_e20113 < _e20101));
let _e20120 = global_2.member[bitcast<u32>(select(0i, _e20115, (_e20115 > 0i)))];
let _e20121 = local_184;
let _e20124 = (1f - _e20061);
let _e20126 = (_e20099 + _e20080);
let _e20128 = select(_e20101, _e20126, (_e20126 < _e20101));
let _e20133 = global_2.member[bitcast<u32>(select(0i, _e20128, (_e20128 > 0i)))];
let _e20134 = local_184;
let _e20137 = local_185;
let _e20138 = (_e20126 + _e20137);
let _e20140 = select(_e20101, _e20138, (_e20138 < _e20101));
let _e20145 = global_2.member[bitcast<u32>(select(0i, _e20140, (_e20140 > 0i)))];
let _e20146 = local_184;
let _e20151 = (_e20099 + (((_e20087 - _e20057) * _e19959) * _e19963));
let _e20153 = select(_e20101, _e20151, (_e20151 < _e20101));
let _e20158 = global_2.member[bitcast<u32>(select(0i, _e20153, (_e20153 > 0i)))];
let _e20159 = local_184;
let _e20162 = local_185;
let _e20163 = (_e20151 + _e20162);
let _e20165 = select(_e20101, _e20163, (_e20163 < _e20101));
let _e20170 = global_2.member[bitcast<u32>(select(0i, _e20165, (_e20165 > 0i)))];
let _e20171 = local_184;
let _e20175 = (_e20151 + _e20080);
let _e20177 = select(_e20101, _e20175, (_e20175 < _e20101));
let _e20182 = global_2.member[bitcast<u32>(select(0i, _e20177, (_e20177 > 0i)))];
let _e20183 = local_184;
let _e20186 = local_185;
let _e20187 = (_e20175 + _e20186);
let _e20189 = select(_e20101, _e20187, (_e20187 < _e20101));
let _e20194 = global_2.member[bitcast<u32>(select(0i, _e20189, (_e20189 > 0i)))];
let _e20195 = local_184;
let _e20204 = ((_e19816 * (_e19946 * (0.25f / 3.1415927f))) * ((((((_e20108 * (1f - _e20109)) + (_e20120 * _e20121)) * _e20124) + (((_e20133 * (1f - _e20134)) + (_e20145 * _e20146)) * _e20061)) * (1f - _e20063)) + (((((_e20158 * (1f - _e20159)) + (_e20170 * _e20171)) * _e20124) + (((_e20182 * (1f - _e20183)) + (_e20194 * _e20195)) * _e20061)) * _e20063)));
let _e20207 = global_1.member.member_12.member_12;
let _e20210 = global_1.member.member_12.member_4;
let _e20213 = global_1.member.member_12.member_13;
let _e20219 = global_1.member.member.member;
let _e20221 = (_e19861 / _e709);
local_181 = bitcast<i32>((_e20207 + (_e20210 * _e20213)));
local_182 = _e299;
local_183 = bitcast<i32>(_e20219);
let _e20224 = global_1.member.member_13.member_6;
let _e20225 = f32(_e20224);
let _e20227 = select(0f, _e20221, (_e20221 > 0f));
let _e20230 = (select(1f, _e20227, (_e20227 < 1f)) * _e20225);
let _e20231 = (_e20225 - 1f);
let _e20233 = select(0f, _e20231, (_e20231 > 0f));
let _e20235 = select(0f, _e20230, (_e20230 > 0f));
let _e20237 = select(_e20233, _e20235, (_e20235 < _e20233));
let _e20244 = select(0i, select(select(i32(_e20237), i32(-2147483648), (_e20237 < -2147483600f)), 2147483647i, (_e20237 > 2147483500f)), (_e20237 == _e20237));
let _e20248 = (_e20244 - select(0i, 1i, (_e20237 < f32(_e20244))));
if (_e20248 > 0i) {
let _e20251 = local_181;
let _e20252 = local_183;
let _e20255 = local_182;
let _e20256 = ((_e20251 + ((_e20248 - 1i) * _e20252)) + _e20255);
let _e20258 = (bitcast<i32>(_e286) - 1i);
let _e20260 = select(_e20258, _e20256, (_e20256 < _e20258));
let _e20265 = global_7.member[bitcast<u32>(select(0i, _e20260, (_e20260 > 0i)))];
phi_13855_ = _e20265;
} else {
phi_13855_ = 0f;
}
let _e20267 = phi_13855_;
let _e20268 = local_181;
let _e20269 = local_183;
let _e20272 = local_182;
let _e20273 = ((_e20268 + (_e20248 * _e20269)) + _e20272);
let _e20275 = (bitcast<i32>(_e286) - 1i);
let _e20277 = select(_e20275, _e20273, (_e20273 < _e20275));
let _e20282 = global_7.member[bitcast<u32>(select(0i, _e20277, (_e20277 > 0i)))];
let _e20289 = (_e19734 - _e19723);
let _e20292 = ((_e19858 - _e19723) / select(1e-9f, _e20289, (_e20289 > 1e-9f)));
local_178 = 0i;
local_179 = _e19743;
local_180 = _e19709;
let _e20294 = select(0f, _e20292, (_e20292 > 0f));
let _e20297 = (select(1f, _e20294, (_e20294 < 1f)) * _e20225);
let _e20299 = select(0f, _e20297, (_e20297 > 0f));
let _e20301 = select(_e20233, _e20299, (_e20299 < _e20233));
let _e20308 = select(0i, select(select(i32(_e20301), i32(-2147483648), (_e20301 < -2147483600f)), 2147483647i, (_e20301 > 2147483500f)), (_e20301 == _e20301));
let _e20312 = (_e20308 - select(0i, 1i, (_e20301 < f32(_e20308))));
if (_e20312 > 0i) {
let _e20315 = local_178;
let _e20316 = local_180;
let _e20319 = local_179;
let _e20320 = ((_e20315 + ((_e20312 - 1i) * _e20316)) + _e20319);
let _e20322 = select(_e20275, _e20320, (_e20320 < _e20275));
let _e20327 = global_7.member[bitcast<u32>(select(0i, _e20322, (_e20322 > 0i)))];
phi_13982_ = _e20327;
} else {
phi_13982_ = 0f;
}
let _e20329 = phi_13982_;
let _e20330 = local_178;
let _e20331 = local_180;
let _e20334 = local_179;
let _e20335 = ((_e20330 + (_e20312 * _e20331)) + _e20334);
let _e20337 = select(_e20275, _e20335, (_e20335 < _e20275));
let _e20342 = global_7.member[bitcast<u32>(select(0i, _e20337, (_e20337 > 0i)))];
let _e20348 = ((_e20267 + ((_e20282 - _e20267) * (_e20230 - f32(_e20248)))) + (_e20329 + ((_e20342 - _e20329) * (_e20297 - f32(_e20312)))));
let _e20351 = global_1.member.member_13.member;
let _e20356 = -((_e20351.member * _e20348));
let _e20358 = select(-87f, _e20356, (_e20356 > -87f));
let _e20360 = select(88f, _e20358, (_e20358 < 88f));
let _e20362 = ((_e20360 * 1.442695f) + 0.5f);
let _e20364 = select(-127f, _e20362, (_e20362 > -127f));
let _e20366 = select(128f, _e20364, (_e20364 < 128f));
let _e20373 = select(0i, select(select(i32(_e20366), i32(-2147483648), (_e20366 < -2147483600f)), 2147483647i, (_e20366 > 2147483500f)), (_e20366 == _e20366));
let _e20377 = (_e20373 - select(0i, 1i, (_e20366 < f32(_e20373))));
let _e20378 = f32(_e20377);
let _e20382 = ((_e20360 - (_e20378 * 0.6933594f)) - (_e20378 * -2.1219444e-4f));
let _e20404 = -((_e20351.member_1 * _e20348));
let _e20406 = select(-87f, _e20404, (_e20404 > -87f));
let _e20408 = select(88f, _e20406, (_e20406 < 88f));
let _e20410 = ((_e20408 * 1.442695f) + 0.5f);
let _e20412 = select(-127f, _e20410, (_e20410 > -127f));
let _e20414 = select(128f, _e20412, (_e20412 < 128f));
let _e20421 = select(0i, select(select(i32(_e20414), i32(-2147483648), (_e20414 < -2147483600f)), 2147483647i, (_e20414 > 2147483500f)), (_e20414 == _e20414));
let _e20425 = (_e20421 - select(0i, 1i, (_e20414 < f32(_e20421))));
let _e20426 = f32(_e20425);
let _e20430 = ((_e20408 - (_e20426 * 0.6933594f)) - (_e20426 * -2.1219444e-4f));
let _e20452 = -((_e20351.member_2 * _e20348));
let _e20454 = select(-87f, _e20452, (_e20452 > -87f));
let _e20456 = select(88f, _e20454, (_e20454 < 88f));
let _e20458 = ((_e20456 * 1.442695f) + 0.5f);
let _e20460 = select(-127f, _e20458, (_e20458 > -127f));
let _e20462 = select(128f, _e20460, (_e20460 < 128f));
let _e20469 = select(0i, select(select(i32(_e20462), i32(-2147483648), (_e20462 < -2147483600f)), 2147483647i, (_e20462 > 2147483500f)), (_e20462 == _e20462));
let _e20473 = (_e20469 - select(0i, 1i, (_e20462 < f32(_e20469))));
let _e20474 = f32(_e20473);
let _e20478 = ((_e20456 - (_e20474 * 0.6933594f)) - (_e20474 * -2.1219444e-4f));
let _e20501 = global_1.member.member_13.member_1;
let _e20514 = select(0f, _e19858, (((_e19861 >= 0f) && (_e19861 < _e709)) && (_e19858 > 0f)));
let _e20515 = (_e784 & 31u);
let _e20517 = (1u << bitcast<u32>(_e20515));
let _e20526 = bitcast<i32>((((_e11927 + _e20517) - 1u) >> bitcast<u32>(_e20515)));
let _e20527 = bitcast<i32>((((_e11930 + _e20517) - 1u) >> bitcast<u32>(_e20515)));
if _e471 {
phi_14270_ = type_26(_e20527, _e20526);
} else {
phi_14270_ = type_26(_e20526, _e20527);
}
let _e20531 = phi_14270_;
let _e20536 = f32((1i << bitcast<u32>(_e20515)));
let _e20537 = (1f / _e20536);
let _e20539 = ((_e19561 * _e20537) - 0.5f);
let _e20541 = ((_e19654 * _e20537) - 0.5f);
let _e20543 = select(-1f, _e20539, (_e20539 > -1f));
let _e20545 = select(1e6f, _e20543, (_e20543 < 1e6f));
let _e20552 = select(0i, select(select(i32(_e20545), i32(-2147483648), (_e20545 < -2147483600f)), 2147483647i, (_e20545 > 2147483500f)), (_e20545 == _e20545));
let _e20556 = (_e20552 - select(0i, 1i, (_e20545 < f32(_e20552))));
let _e20558 = select(-1f, _e20541, (_e20541 > -1f));
let _e20560 = select(1e6f, _e20558, (_e20558 < 1e6f));
let _e20567 = select(0i, select(select(i32(_e20560), i32(-2147483648), (_e20560 < -2147483600f)), 2147483647i, (_e20560 > 2147483500f)), (_e20560 == _e20560));
let _e20571 = (_e20567 - select(0i, 1i, (_e20560 < f32(_e20567))));
let _e20573 = (_e20539 - f32(_e20556));
let _e20575 = (_e20541 - f32(_e20571));
let _e20576 = (1f - _e20573);
let _e20577 = (1f - _e20575);
let _e20580 = select(_e20556, 0i, (_e20556 < 0i));
let _e20581 = (_e20580 >= _e20531.member);
if _e20581 {
phi_14348_ = (_e20531.member - 1i);
} else {
phi_14348_ = _e20580;
}
let _e20584 = phi_14348_;
let _e20586 = select(_e20571, 0i, (_e20571 < 0i));
let _e20587 = (_e20586 >= _e20531.member_1);
if _e20587 {
phi_14359_ = (_e20531.member_1 - 1i);
} else {
phi_14359_ = _e20586;
}
let _e20590 = phi_14359_;
let _e20594 = (((f32(_e20584) + 0.5f) * _e20536) - 0.5f);
let _e20598 = (((f32(_e20590) + 0.5f) * _e20536) - 0.5f);
if _e471 {
phi_14387_ = type_26(_e20590, _e20584);
} else {
phi_14387_ = type_26(_e20584, _e20590);
}
let _e20604 = phi_14387_;
let _e20610 = bitcast<i32>(((_e11927 + 1u) >> bitcast<u32>(1u)));
let _e20613 = global_1.member.member_18.member_6;
let _e20616 = global_1.member.member_18.member_7;
let _e20619 = global_1.member.member_18.member_8;
if _e11982 {
phi_14438_ = 0u;
} else {
if (_e784 == 1u) {
phi_14437_ = 0u;
} else {
if (_e784 == 2u) {
phi_14436_ = _e20613;
} else {
phi_14436_ = select(_e20619, _e20616, (_e784 == 3u));
}
let _e20625 = phi_14436_;
phi_14437_ = _e20625;
}
let _e20627 = phi_14437_;
phi_14438_ = _e20627;
}
let _e20629 = phi_14438_;
local_176 = (((bitcast<i32>(_e20629) + _e20604.member_1) * _e20610) + _e20604.member);
let _e20634 = local_176;
let _e20636 = (bitcast<i32>(_e280) - 1i);
let _e20638 = select(_e20636, _e20634, (_e20634 < _e20636));
let _e20643 = global_6.member[bitcast<u32>(select(0i, _e20638, (_e20638 > 0i)))];
let _e20648 = (((((select(_e20594, _e20598, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e20653 = ((1f - (((select(_e20598, _e20594, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e20660 = ((_e19765.member * _e20648) + (_e19773.member * _e20653));
let _e20661 = ((_e19765.member_1 * _e20648) + (_e19773.member_1 * _e20653));
let _e20662 = ((_e19765.member_2 * _e20648) + (_e19773.member_2 * _e20653));
let _e20666 = select((_e19788.member + _e20660), _e19788.member, _e19786);
let _e20667 = select((_e19788.member_1 + _e20661), _e19788.member_1, _e19786);
let _e20668 = select((_e19788.member_2 + _e20662), _e19788.member_2, _e19786);
let _e20679 = (((_e20666 * _e20666) + (_e20667 * _e20667)) + (_e20668 * _e20668));
let _e20683 = (1f / sqrt(select(0f, _e20679, (_e20679 > 0f))));
let _e20684 = (_e20666 * _e20683);
let _e20685 = (_e20667 * _e20683);
let _e20686 = (_e20668 * _e20683);
let _e20687 = (_e593 - select(_e19799.member, (_e19799.member + _e20660), _e19786));
let _e20688 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e20661), _e19786));
let _e20689 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e20662), _e19786));
let _e20694 = (((_e20687 * _e20684) + (_e20688 * _e20685)) + (_e20689 * _e20686));
let _e20699 = (((_e20687 * _e631) + (_e20688 * _e644)) + (_e20689 * _e657));
let _e20704 = (((_e20684 * _e631) + (_e20685 * _e644)) + (_e20686 * _e657));
let _e20707 = ((_e20685 * _e657) - (_e20686 * _e644));
let _e20710 = ((_e20686 * _e631) - (_e20684 * _e657));
let _e20713 = ((_e20684 * _e644) - (_e20685 * _e631));
let _e20718 = (((_e20707 * _e20707) + (_e20710 * _e20710)) + (_e20713 * _e20713));
let _e20721 = (1f / select(1e-9f, _e20718, (_e20718 > 1e-9f)));
let _e20724 = ((_e20694 - (_e20704 * _e20699)) * _e20721);
let _e20727 = (((_e20704 * _e20694) - _e20699) * _e20721);
let _e20733 = select(0f, _e20724, (((_e20727 >= 0f) && (_e20727 < _e709)) && (_e20724 > 0f)));
let _e20735 = (_e20584 << bitcast<u32>(_e20515));
let _e20747 = (_e20556 + 1i);
let _e20750 = select(_e20747, 0i, (_e20747 < 0i));
let _e20751 = (_e20750 >= _e20531.member);
if _e20751 {
phi_15422_ = (_e20531.member - 1i);
} else {
phi_15422_ = _e20750;
}
let _e20754 = phi_15422_;
if _e20587 {
phi_15433_ = (_e20531.member_1 - 1i);
} else {
phi_15433_ = _e20586;
}
let _e20757 = phi_15433_;
let _e20761 = (((f32(_e20754) + 0.5f) * _e20536) - 0.5f);
let _e20765 = (((f32(_e20757) + 0.5f) * _e20536) - 0.5f);
if _e471 {
phi_15461_ = type_26(_e20757, _e20754);
} else {
phi_15461_ = type_26(_e20754, _e20757);
}
let _e20771 = phi_15461_;
if _e11982 {
phi_15512_ = 0u;
} else {
if (_e784 == 1u) {
phi_15511_ = 0u;
} else {
if (_e784 == 2u) {
phi_15510_ = _e20613;
} else {
phi_15510_ = select(_e20619, _e20616, (_e784 == 3u));
}
let _e20779 = phi_15510_;
phi_15511_ = _e20779;
}
let _e20781 = phi_15511_;
phi_15512_ = _e20781;
}
let _e20783 = phi_15512_;
local_174 = (((bitcast<i32>(_e20783) + _e20771.member_1) * _e20610) + _e20771.member);
let _e20788 = local_174;
let _e20790 = select(_e20636, _e20788, (_e20788 < _e20636));
let _e20795 = global_6.member[bitcast<u32>(select(0i, _e20790, (_e20790 > 0i)))];
let _e20800 = (((((select(_e20761, _e20765, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e20805 = ((1f - (((select(_e20765, _e20761, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e20812 = ((_e19765.member * _e20800) + (_e19773.member * _e20805));
let _e20813 = ((_e19765.member_1 * _e20800) + (_e19773.member_1 * _e20805));
let _e20814 = ((_e19765.member_2 * _e20800) + (_e19773.member_2 * _e20805));
let _e20818 = select((_e19788.member + _e20812), _e19788.member, _e19786);
let _e20819 = select((_e19788.member_1 + _e20813), _e19788.member_1, _e19786);
let _e20820 = select((_e19788.member_2 + _e20814), _e19788.member_2, _e19786);
let _e20831 = (((_e20818 * _e20818) + (_e20819 * _e20819)) + (_e20820 * _e20820));
let _e20835 = (1f / sqrt(select(0f, _e20831, (_e20831 > 0f))));
let _e20836 = (_e20818 * _e20835);
let _e20837 = (_e20819 * _e20835);
let _e20838 = (_e20820 * _e20835);
let _e20839 = (_e593 - select(_e19799.member, (_e19799.member + _e20812), _e19786));
let _e20840 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e20813), _e19786));
let _e20841 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e20814), _e19786));
let _e20846 = (((_e20839 * _e20836) + (_e20840 * _e20837)) + (_e20841 * _e20838));
let _e20851 = (((_e20839 * _e631) + (_e20840 * _e644)) + (_e20841 * _e657));
let _e20856 = (((_e20836 * _e631) + (_e20837 * _e644)) + (_e20838 * _e657));
let _e20859 = ((_e20837 * _e657) - (_e20838 * _e644));
let _e20862 = ((_e20838 * _e631) - (_e20836 * _e657));
let _e20865 = ((_e20836 * _e644) - (_e20837 * _e631));
let _e20870 = (((_e20859 * _e20859) + (_e20862 * _e20862)) + (_e20865 * _e20865));
let _e20873 = (1f / select(1e-9f, _e20870, (_e20870 > 1e-9f)));
let _e20876 = ((_e20846 - (_e20856 * _e20851)) * _e20873);
let _e20879 = (((_e20856 * _e20846) - _e20851) * _e20873);
let _e20885 = select(0f, _e20876, (((_e20879 >= 0f) && (_e20879 < _e709)) && (_e20876 > 0f)));
let _e20887 = (_e20754 << bitcast<u32>(_e20515));
let _e20899 = (_e20571 + 1i);
if _e20581 {
phi_16496_ = (_e20531.member - 1i);
} else {
phi_16496_ = _e20580;
}
let _e20903 = phi_16496_;
let _e20905 = select(_e20899, 0i, (_e20899 < 0i));
let _e20906 = (_e20905 >= _e20531.member_1);
if _e20906 {
phi_16507_ = (_e20531.member_1 - 1i);
} else {
phi_16507_ = _e20905;
}
let _e20909 = phi_16507_;
let _e20913 = (((f32(_e20903) + 0.5f) * _e20536) - 0.5f);
let _e20917 = (((f32(_e20909) + 0.5f) * _e20536) - 0.5f);
if _e471 {
phi_16535_ = type_26(_e20909, _e20903);
} else {
phi_16535_ = type_26(_e20903, _e20909);
}
let _e20923 = phi_16535_;
if _e11982 {
phi_16586_ = 0u;
} else {
if (_e784 == 1u) {
phi_16585_ = 0u;
} else {
if (_e784 == 2u) {
phi_16584_ = _e20613;
} else {
phi_16584_ = select(_e20619, _e20616, (_e784 == 3u));
}
let _e20931 = phi_16584_;
phi_16585_ = _e20931;
}
let _e20933 = phi_16585_;
phi_16586_ = _e20933;
}
let _e20935 = phi_16586_;
local_172 = (((bitcast<i32>(_e20935) + _e20923.member_1) * _e20610) + _e20923.member);
let _e20940 = local_172;
let _e20942 = select(_e20636, _e20940, (_e20940 < _e20636));
let _e20947 = global_6.member[bitcast<u32>(select(0i, _e20942, (_e20942 > 0i)))];
let _e20952 = (((((select(_e20913, _e20917, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e20957 = ((1f - (((select(_e20917, _e20913, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e20964 = ((_e19765.member * _e20952) + (_e19773.member * _e20957));
let _e20965 = ((_e19765.member_1 * _e20952) + (_e19773.member_1 * _e20957));
let _e20966 = ((_e19765.member_2 * _e20952) + (_e19773.member_2 * _e20957));
let _e20970 = select((_e19788.member + _e20964), _e19788.member, _e19786);
let _e20971 = select((_e19788.member_1 + _e20965), _e19788.member_1, _e19786);
let _e20972 = select((_e19788.member_2 + _e20966), _e19788.member_2, _e19786);
let _e20983 = (((_e20970 * _e20970) + (_e20971 * _e20971)) + (_e20972 * _e20972));
let _e20987 = (1f / sqrt(select(0f, _e20983, (_e20983 > 0f))));
let _e20988 = (_e20970 * _e20987);
let _e20989 = (_e20971 * _e20987);
let _e20990 = (_e20972 * _e20987);
let _e20991 = (_e593 - select(_e19799.member, (_e19799.member + _e20964), _e19786));
let _e20992 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e20965), _e19786));
let _e20993 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e20966), _e19786));
let _e20998 = (((_e20991 * _e20988) + (_e20992 * _e20989)) + (_e20993 * _e20990));
let _e21003 = (((_e20991 * _e631) + (_e20992 * _e644)) + (_e20993 * _e657));
let _e21008 = (((_e20988 * _e631) + (_e20989 * _e644)) + (_e20990 * _e657));
let _e21011 = ((_e20989 * _e657) - (_e20990 * _e644));
let _e21014 = ((_e20990 * _e631) - (_e20988 * _e657));
let _e21017 = ((_e20988 * _e644) - (_e20989 * _e631));
let _e21022 = (((_e21011 * _e21011) + (_e21014 * _e21014)) + (_e21017 * _e21017));
let _e21025 = (1f / select(1e-9f, _e21022, (_e21022 > 1e-9f)));
let _e21028 = ((_e20998 - (_e21008 * _e21003)) * _e21025);
let _e21031 = (((_e21008 * _e20998) - _e21003) * _e21025);
let _e21037 = select(0f, _e21028, (((_e21031 >= 0f) && (_e21031 < _e709)) && (_e21028 > 0f)));
let _e21039 = (_e20903 << bitcast<u32>(_e20515));
if _e20751 {
phi_17570_ = (_e20531.member - 1i);
} else {
phi_17570_ = _e20750;
}
let _e21054 = phi_17570_;
if _e20906 {
phi_17581_ = (_e20531.member_1 - 1i);
} else {
phi_17581_ = _e20905;
}
let _e21057 = phi_17581_;
let _e21061 = (((f32(_e21054) + 0.5f) * _e20536) - 0.5f);
let _e21065 = (((f32(_e21057) + 0.5f) * _e20536) - 0.5f);
if _e471 {
phi_17609_ = type_26(_e21057, _e21054);
} else {
phi_17609_ = type_26(_e21054, _e21057);
}
let _e21071 = phi_17609_;
if _e11982 {
phi_17660_ = 0u;
} else {
if (_e784 == 1u) {
phi_17659_ = 0u;
} else {
if (_e784 == 2u) {
phi_17658_ = _e20613;
} else {
phi_17658_ = select(_e20619, _e20616, (_e784 == 3u));
}
let _e21079 = phi_17658_;
phi_17659_ = _e21079;
}
let _e21081 = phi_17659_;
phi_17660_ = _e21081;
}
let _e21083 = phi_17660_;
local_170 = (((bitcast<i32>(_e21083) + _e21071.member_1) * _e20610) + _e21071.member);
let _e21088 = local_170;
let _e21090 = select(_e20636, _e21088, (_e21088 < _e20636));
let _e21095 = global_6.member[bitcast<u32>(select(0i, _e21090, (_e21090 > 0i)))];
let _e21100 = (((((select(_e21061, _e21065, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e21105 = ((1f - (((select(_e21065, _e21061, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e21112 = ((_e19765.member * _e21100) + (_e19773.member * _e21105));
let _e21113 = ((_e19765.member_1 * _e21100) + (_e19773.member_1 * _e21105));
let _e21114 = ((_e19765.member_2 * _e21100) + (_e19773.member_2 * _e21105));
let _e21118 = select((_e19788.member + _e21112), _e19788.member, _e19786);
let _e21119 = select((_e19788.member_1 + _e21113), _e19788.member_1, _e19786);
let _e21120 = select((_e19788.member_2 + _e21114), _e19788.member_2, _e19786);
let _e21131 = (((_e21118 * _e21118) + (_e21119 * _e21119)) + (_e21120 * _e21120));
let _e21135 = (1f / sqrt(select(0f, _e21131, (_e21131 > 0f))));
let _e21136 = (_e21118 * _e21135);
let _e21137 = (_e21119 * _e21135);
let _e21138 = (_e21120 * _e21135);
let _e21139 = (_e593 - select(_e19799.member, (_e19799.member + _e21112), _e19786));
let _e21140 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e21113), _e19786));
let _e21141 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e21114), _e19786));
let _e21146 = (((_e21139 * _e21136) + (_e21140 * _e21137)) + (_e21141 * _e21138));
let _e21151 = (((_e21139 * _e631) + (_e21140 * _e644)) + (_e21141 * _e657));
let _e21156 = (((_e21136 * _e631) + (_e21137 * _e644)) + (_e21138 * _e657));
let _e21159 = ((_e21137 * _e657) - (_e21138 * _e644));
let _e21162 = ((_e21138 * _e631) - (_e21136 * _e657));
let _e21165 = ((_e21136 * _e644) - (_e21137 * _e631));
let _e21170 = (((_e21159 * _e21159) + (_e21162 * _e21162)) + (_e21165 * _e21165));
let _e21173 = (1f / select(1e-9f, _e21170, (_e21170 > 1e-9f)));
let _e21176 = ((_e21146 - (_e21156 * _e21151)) * _e21173);
let _e21179 = (((_e21156 * _e21146) - _e21151) * _e21173);
let _e21185 = select(0f, _e21176, (((_e21179 >= 0f) && (_e21179 < _e709)) && (_e21176 > 0f)));
let _e21187 = (_e21054 << bitcast<u32>(_e20515));
let _e21199 = select(((((1f - select(0f, (_e20576 * _e20577), (((select(select(_e784, _e941, (_e20735 >= _e710)), _e863, (_e20735 < _e316)) == _e784) && (_e20733 > 0f)) && (_e20733 < _e20643)))) - select(0f, (_e20573 * _e20577), (((select(select(_e784, _e941, (_e20887 >= _e710)), _e863, (_e20887 < _e316)) == _e784) && (_e20885 > 0f)) && (_e20885 < _e20795)))) - select(0f, (_e20576 * _e20575), (((select(select(_e784, _e941, (_e21039 >= _e710)), _e863, (_e21039 < _e316)) == _e784) && (_e21037 > 0f)) && (_e21037 < _e20947)))) - select(0f, (_e20573 * _e20575), (((select(select(_e784, _e941, (_e21187 >= _e710)), _e863, (_e21187 < _e316)) == _e784) && (_e21185 > 0f)) && (_e21185 < _e21095)))), 1f, _e11982);
let _e21200 = (_e19540 & 31u);
let _e21202 = (1u << bitcast<u32>(_e21200));
let _e21211 = bitcast<i32>((((_e11927 + _e21202) - 1u) >> bitcast<u32>(_e21200)));
let _e21212 = bitcast<i32>((((_e11930 + _e21202) - 1u) >> bitcast<u32>(_e21200)));
if _e471 {
phi_18662_ = type_26(_e21212, _e21211);
} else {
phi_18662_ = type_26(_e21211, _e21212);
}
let _e21216 = phi_18662_;
let _e21221 = f32((1i << bitcast<u32>(_e21200)));
let _e21222 = (1f / _e21221);
let _e21224 = ((_e19561 * _e21222) - 0.5f);
let _e21226 = ((_e19654 * _e21222) - 0.5f);
let _e21228 = select(-1f, _e21224, (_e21224 > -1f));
let _e21230 = select(1e6f, _e21228, (_e21228 < 1e6f));
let _e21237 = select(0i, select(select(i32(_e21230), i32(-2147483648), (_e21230 < -2147483600f)), 2147483647i, (_e21230 > 2147483500f)), (_e21230 == _e21230));
let _e21241 = (_e21237 - select(0i, 1i, (_e21230 < f32(_e21237))));
let _e21243 = select(-1f, _e21226, (_e21226 > -1f));
let _e21245 = select(1e6f, _e21243, (_e21243 < 1e6f));
let _e21252 = select(0i, select(select(i32(_e21245), i32(-2147483648), (_e21245 < -2147483600f)), 2147483647i, (_e21245 > 2147483500f)), (_e21245 == _e21245));
let _e21256 = (_e21252 - select(0i, 1i, (_e21245 < f32(_e21252))));
let _e21258 = (_e21224 - f32(_e21241));
let _e21260 = (_e21226 - f32(_e21256));
let _e21261 = (1f - _e21258);
let _e21262 = (1f - _e21260);
let _e21265 = select(_e21241, 0i, (_e21241 < 0i));
let _e21266 = (_e21265 >= _e21216.member);
if _e21266 {
phi_18740_ = (_e21216.member - 1i);
} else {
phi_18740_ = _e21265;
}
let _e21269 = phi_18740_;
let _e21271 = select(_e21256, 0i, (_e21256 < 0i));
let _e21272 = (_e21271 >= _e21216.member_1);
if _e21272 {
phi_18751_ = (_e21216.member_1 - 1i);
} else {
phi_18751_ = _e21271;
}
let _e21275 = phi_18751_;
let _e21279 = (((f32(_e21269) + 0.5f) * _e21221) - 0.5f);
let _e21283 = (((f32(_e21275) + 0.5f) * _e21221) - 0.5f);
if _e471 {
phi_18779_ = type_26(_e21275, _e21269);
} else {
phi_18779_ = type_26(_e21269, _e21275);
}
let _e21289 = phi_18779_;
let _e21292 = (_e19540 == 0u);
if _e21292 {
phi_18830_ = 0u;
} else {
if (_e19540 == 1u) {
phi_18829_ = 0u;
} else {
if (_e19540 == 2u) {
phi_18828_ = _e20613;
} else {
phi_18828_ = select(_e20619, _e20616, (_e19540 == 3u));
}
let _e21298 = phi_18828_;
phi_18829_ = _e21298;
}
let _e21300 = phi_18829_;
phi_18830_ = _e21300;
}
let _e21302 = phi_18830_;
local_168 = (((bitcast<i32>(_e21302) + _e21289.member_1) * _e20610) + _e21289.member);
let _e21307 = local_168;
let _e21309 = select(_e20636, _e21307, (_e21307 < _e20636));
let _e21314 = global_6.member[bitcast<u32>(select(0i, _e21309, (_e21309 > 0i)))];
let _e21319 = (((((select(_e21279, _e21283, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e21324 = ((1f - (((select(_e21283, _e21279, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e21331 = ((_e19765.member * _e21319) + (_e19773.member * _e21324));
let _e21332 = ((_e19765.member_1 * _e21319) + (_e19773.member_1 * _e21324));
let _e21333 = ((_e19765.member_2 * _e21319) + (_e19773.member_2 * _e21324));
let _e21337 = select((_e19788.member + _e21331), _e19788.member, _e19786);
let _e21338 = select((_e19788.member_1 + _e21332), _e19788.member_1, _e19786);
let _e21339 = select((_e19788.member_2 + _e21333), _e19788.member_2, _e19786);
let _e21350 = (((_e21337 * _e21337) + (_e21338 * _e21338)) + (_e21339 * _e21339));
let _e21354 = (1f / sqrt(select(0f, _e21350, (_e21350 > 0f))));
let _e21355 = (_e21337 * _e21354);
let _e21356 = (_e21338 * _e21354);
let _e21357 = (_e21339 * _e21354);
let _e21358 = (_e593 - select(_e19799.member, (_e19799.member + _e21331), _e19786));
let _e21359 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e21332), _e19786));
let _e21360 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e21333), _e19786));
let _e21365 = (((_e21358 * _e21355) + (_e21359 * _e21356)) + (_e21360 * _e21357));
let _e21370 = (((_e21358 * _e631) + (_e21359 * _e644)) + (_e21360 * _e657));
let _e21375 = (((_e21355 * _e631) + (_e21356 * _e644)) + (_e21357 * _e657));
let _e21378 = ((_e21356 * _e657) - (_e21357 * _e644));
let _e21381 = ((_e21357 * _e631) - (_e21355 * _e657));
let _e21384 = ((_e21355 * _e644) - (_e21356 * _e631));
let _e21389 = (((_e21378 * _e21378) + (_e21381 * _e21381)) + (_e21384 * _e21384));
let _e21392 = (1f / select(1e-9f, _e21389, (_e21389 > 1e-9f)));
let _e21395 = ((_e21365 - (_e21375 * _e21370)) * _e21392);
let _e21398 = (((_e21375 * _e21365) - _e21370) * _e21392);
let _e21404 = select(0f, _e21395, (((_e21398 >= 0f) && (_e21398 < _e709)) && (_e21395 > 0f)));
let _e21406 = (_e21269 << bitcast<u32>(_e21200));
let _e21418 = (_e21241 + 1i);
let _e21421 = select(_e21418, 0i, (_e21418 < 0i));
let _e21422 = (_e21421 >= _e21216.member);
if _e21422 {
phi_19814_ = (_e21216.member - 1i);
} else {
phi_19814_ = _e21421;
}
let _e21425 = phi_19814_;
if _e21272 {
phi_19825_ = (_e21216.member_1 - 1i);
} else {
phi_19825_ = _e21271;
}
let _e21428 = phi_19825_;
let _e21432 = (((f32(_e21425) + 0.5f) * _e21221) - 0.5f);
let _e21436 = (((f32(_e21428) + 0.5f) * _e21221) - 0.5f);
if _e471 {
phi_19853_ = type_26(_e21428, _e21425);
} else {
phi_19853_ = type_26(_e21425, _e21428);
}
let _e21442 = phi_19853_;
if _e21292 {
phi_19904_ = 0u;
} else {
if (_e19540 == 1u) {
phi_19903_ = 0u;
} else {
if (_e19540 == 2u) {
phi_19902_ = _e20613;
} else {
phi_19902_ = select(_e20619, _e20616, (_e19540 == 3u));
}
let _e21450 = phi_19902_;
phi_19903_ = _e21450;
}
let _e21452 = phi_19903_;
phi_19904_ = _e21452;
}
let _e21454 = phi_19904_;
local_166 = (((bitcast<i32>(_e21454) + _e21442.member_1) * _e20610) + _e21442.member);
let _e21459 = local_166;
let _e21461 = select(_e20636, _e21459, (_e21459 < _e20636));
let _e21466 = global_6.member[bitcast<u32>(select(0i, _e21461, (_e21461 > 0i)))];
let _e21471 = (((((select(_e21432, _e21436, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e21476 = ((1f - (((select(_e21436, _e21432, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e21483 = ((_e19765.member * _e21471) + (_e19773.member * _e21476));
let _e21484 = ((_e19765.member_1 * _e21471) + (_e19773.member_1 * _e21476));
let _e21485 = ((_e19765.member_2 * _e21471) + (_e19773.member_2 * _e21476));
let _e21489 = select((_e19788.member + _e21483), _e19788.member, _e19786);
let _e21490 = select((_e19788.member_1 + _e21484), _e19788.member_1, _e19786);
let _e21491 = select((_e19788.member_2 + _e21485), _e19788.member_2, _e19786);
let _e21502 = (((_e21489 * _e21489) + (_e21490 * _e21490)) + (_e21491 * _e21491));
let _e21506 = (1f / sqrt(select(0f, _e21502, (_e21502 > 0f))));
let _e21507 = (_e21489 * _e21506);
let _e21508 = (_e21490 * _e21506);
let _e21509 = (_e21491 * _e21506);
let _e21510 = (_e593 - select(_e19799.member, (_e19799.member + _e21483), _e19786));
let _e21511 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e21484), _e19786));
let _e21512 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e21485), _e19786));
let _e21517 = (((_e21510 * _e21507) + (_e21511 * _e21508)) + (_e21512 * _e21509));
let _e21522 = (((_e21510 * _e631) + (_e21511 * _e644)) + (_e21512 * _e657));
let _e21527 = (((_e21507 * _e631) + (_e21508 * _e644)) + (_e21509 * _e657));
let _e21530 = ((_e21508 * _e657) - (_e21509 * _e644));
let _e21533 = ((_e21509 * _e631) - (_e21507 * _e657));
let _e21536 = ((_e21507 * _e644) - (_e21508 * _e631));
let _e21541 = (((_e21530 * _e21530) + (_e21533 * _e21533)) + (_e21536 * _e21536));
let _e21544 = (1f / select(1e-9f, _e21541, (_e21541 > 1e-9f)));
let _e21547 = ((_e21517 - (_e21527 * _e21522)) * _e21544);
let _e21550 = (((_e21527 * _e21517) - _e21522) * _e21544);
let _e21556 = select(0f, _e21547, (((_e21550 >= 0f) && (_e21550 < _e709)) && (_e21547 > 0f)));
let _e21558 = (_e21425 << bitcast<u32>(_e21200));
let _e21570 = (_e21256 + 1i);
if _e21266 {
phi_20888_ = (_e21216.member - 1i);
} else {
phi_20888_ = _e21265;
}
let _e21574 = phi_20888_;
let _e21576 = select(_e21570, 0i, (_e21570 < 0i));
let _e21577 = (_e21576 >= _e21216.member_1);
if _e21577 {
phi_20899_ = (_e21216.member_1 - 1i);
} else {
phi_20899_ = _e21576;
}
let _e21580 = phi_20899_;
let _e21584 = (((f32(_e21574) + 0.5f) * _e21221) - 0.5f);
let _e21588 = (((f32(_e21580) + 0.5f) * _e21221) - 0.5f);
if _e471 {
phi_20927_ = type_26(_e21580, _e21574);
} else {
phi_20927_ = type_26(_e21574, _e21580);
}
let _e21594 = phi_20927_;
if _e21292 {
phi_20978_ = 0u;
} else {
if (_e19540 == 1u) {
phi_20977_ = 0u;
} else {
if (_e19540 == 2u) {
phi_20976_ = _e20613;
} else {
phi_20976_ = select(_e20619, _e20616, (_e19540 == 3u));
}
let _e21602 = phi_20976_;
phi_20977_ = _e21602;
}
let _e21604 = phi_20977_;
phi_20978_ = _e21604;
}
let _e21606 = phi_20978_;
local_164 = (((bitcast<i32>(_e21606) + _e21594.member_1) * _e20610) + _e21594.member);
let _e21611 = local_164;
let _e21613 = select(_e20636, _e21611, (_e21611 < _e20636));
let _e21618 = global_6.member[bitcast<u32>(select(0i, _e21613, (_e21613 > 0i)))];
let _e21623 = (((((select(_e21584, _e21588, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e21628 = ((1f - (((select(_e21588, _e21584, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e21635 = ((_e19765.member * _e21623) + (_e19773.member * _e21628));
let _e21636 = ((_e19765.member_1 * _e21623) + (_e19773.member_1 * _e21628));
let _e21637 = ((_e19765.member_2 * _e21623) + (_e19773.member_2 * _e21628));
let _e21641 = select((_e19788.member + _e21635), _e19788.member, _e19786);
let _e21642 = select((_e19788.member_1 + _e21636), _e19788.member_1, _e19786);
let _e21643 = select((_e19788.member_2 + _e21637), _e19788.member_2, _e19786);
let _e21654 = (((_e21641 * _e21641) + (_e21642 * _e21642)) + (_e21643 * _e21643));
let _e21658 = (1f / sqrt(select(0f, _e21654, (_e21654 > 0f))));
let _e21659 = (_e21641 * _e21658);
let _e21660 = (_e21642 * _e21658);
let _e21661 = (_e21643 * _e21658);
let _e21662 = (_e593 - select(_e19799.member, (_e19799.member + _e21635), _e19786));
let _e21663 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e21636), _e19786));
let _e21664 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e21637), _e19786));
let _e21669 = (((_e21662 * _e21659) + (_e21663 * _e21660)) + (_e21664 * _e21661));
let _e21674 = (((_e21662 * _e631) + (_e21663 * _e644)) + (_e21664 * _e657));
let _e21679 = (((_e21659 * _e631) + (_e21660 * _e644)) + (_e21661 * _e657));
let _e21682 = ((_e21660 * _e657) - (_e21661 * _e644));
let _e21685 = ((_e21661 * _e631) - (_e21659 * _e657));
let _e21688 = ((_e21659 * _e644) - (_e21660 * _e631));
let _e21693 = (((_e21682 * _e21682) + (_e21685 * _e21685)) + (_e21688 * _e21688));
let _e21696 = (1f / select(1e-9f, _e21693, (_e21693 > 1e-9f)));
let _e21699 = ((_e21669 - (_e21679 * _e21674)) * _e21696);
let _e21702 = (((_e21679 * _e21669) - _e21674) * _e21696);
let _e21708 = select(0f, _e21699, (((_e21702 >= 0f) && (_e21702 < _e709)) && (_e21699 > 0f)));
let _e21710 = (_e21574 << bitcast<u32>(_e21200));
if _e21422 {
phi_21962_ = (_e21216.member - 1i);
} else {
phi_21962_ = _e21421;
}
let _e21725 = phi_21962_;
if _e21577 {
phi_21973_ = (_e21216.member_1 - 1i);
} else {
phi_21973_ = _e21576;
}
let _e21728 = phi_21973_;
let _e21732 = (((f32(_e21725) + 0.5f) * _e21221) - 0.5f);
let _e21736 = (((f32(_e21728) + 0.5f) * _e21221) - 0.5f);
if _e471 {
phi_22001_ = type_26(_e21728, _e21725);
} else {
phi_22001_ = type_26(_e21725, _e21728);
}
let _e21742 = phi_22001_;
if _e21292 {
phi_22052_ = 0u;
} else {
if (_e19540 == 1u) {
phi_22051_ = 0u;
} else {
if (_e19540 == 2u) {
phi_22050_ = _e20613;
} else {
phi_22050_ = select(_e20619, _e20616, (_e19540 == 3u));
}
let _e21750 = phi_22050_;
phi_22051_ = _e21750;
}
let _e21752 = phi_22051_;
phi_22052_ = _e21752;
}
let _e21754 = phi_22052_;
local_162 = (((bitcast<i32>(_e21754) + _e21742.member_1) * _e20610) + _e21742.member);
let _e21759 = local_162;
let _e21761 = select(_e20636, _e21759, (_e21759 < _e20636));
let _e21766 = global_6.member[bitcast<u32>(select(0i, _e21761, (_e21761 > 0i)))];
let _e21771 = (((((select(_e21732, _e21736, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e21776 = ((1f - (((select(_e21736, _e21732, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e21783 = ((_e19765.member * _e21771) + (_e19773.member * _e21776));
let _e21784 = ((_e19765.member_1 * _e21771) + (_e19773.member_1 * _e21776));
let _e21785 = ((_e19765.member_2 * _e21771) + (_e19773.member_2 * _e21776));
let _e21789 = select((_e19788.member + _e21783), _e19788.member, _e19786);
let _e21790 = select((_e19788.member_1 + _e21784), _e19788.member_1, _e19786);
let _e21791 = select((_e19788.member_2 + _e21785), _e19788.member_2, _e19786);
let _e21802 = (((_e21789 * _e21789) + (_e21790 * _e21790)) + (_e21791 * _e21791));
let _e21806 = (1f / sqrt(select(0f, _e21802, (_e21802 > 0f))));
let _e21807 = (_e21789 * _e21806);
let _e21808 = (_e21790 * _e21806);
let _e21809 = (_e21791 * _e21806);
let _e21810 = (_e593 - select(_e19799.member, (_e19799.member + _e21783), _e19786));
let _e21811 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e21784), _e19786));
let _e21812 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e21785), _e19786));
let _e21817 = (((_e21810 * _e21807) + (_e21811 * _e21808)) + (_e21812 * _e21809));
let _e21822 = (((_e21810 * _e631) + (_e21811 * _e644)) + (_e21812 * _e657));
let _e21827 = (((_e21807 * _e631) + (_e21808 * _e644)) + (_e21809 * _e657));
let _e21830 = ((_e21808 * _e657) - (_e21809 * _e644));
let _e21833 = ((_e21809 * _e631) - (_e21807 * _e657));
let _e21836 = ((_e21807 * _e644) - (_e21808 * _e631));
let _e21841 = (((_e21830 * _e21830) + (_e21833 * _e21833)) + (_e21836 * _e21836));
let _e21844 = (1f / select(1e-9f, _e21841, (_e21841 > 1e-9f)));
let _e21847 = ((_e21817 - (_e21827 * _e21822)) * _e21844);
let _e21850 = (((_e21827 * _e21817) - _e21822) * _e21844);
let _e21856 = select(0f, _e21847, (((_e21850 >= 0f) && (_e21850 < _e709)) && (_e21847 > 0f)));
let _e21858 = (_e21725 << bitcast<u32>(_e21200));
let _e21870 = select(((((_e21199 - select(0f, (_e21261 * _e21262), (((select(select(_e784, _e941, (_e21406 >= _e710)), _e863, (_e21406 < _e316)) == _e19540) && (_e21404 > 0f)) && (_e21404 < _e21314)))) - select(0f, (_e21258 * _e21262), (((select(select(_e784, _e941, (_e21558 >= _e710)), _e863, (_e21558 < _e316)) == _e19540) && (_e21556 > 0f)) && (_e21556 < _e21466)))) - select(0f, (_e21261 * _e21260), (((select(select(_e784, _e941, (_e21710 >= _e710)), _e863, (_e21710 < _e316)) == _e19540) && (_e21708 > 0f)) && (_e21708 < _e21618)))) - select(0f, (_e21258 * _e21260), (((select(select(_e784, _e941, (_e21858 >= _e710)), _e863, (_e21858 < _e316)) == _e19540) && (_e21856 > 0f)) && (_e21856 < _e21766)))), _e21199, _e21292);
let _e21871 = (_e19544 & 31u);
let _e21873 = (1u << bitcast<u32>(_e21871));
let _e21882 = bitcast<i32>((((_e11927 + _e21873) - 1u) >> bitcast<u32>(_e21871)));
let _e21883 = bitcast<i32>((((_e11930 + _e21873) - 1u) >> bitcast<u32>(_e21871)));
if _e471 {
phi_23054_ = type_26(_e21883, _e21882);
} else {
phi_23054_ = type_26(_e21882, _e21883);
}
let _e21887 = phi_23054_;
let _e21892 = f32((1i << bitcast<u32>(_e21871)));
let _e21893 = (1f / _e21892);
let _e21895 = ((_e19561 * _e21893) - 0.5f);
let _e21897 = ((_e19654 * _e21893) - 0.5f);
let _e21899 = select(-1f, _e21895, (_e21895 > -1f));
let _e21901 = select(1e6f, _e21899, (_e21899 < 1e6f));
let _e21908 = select(0i, select(select(i32(_e21901), i32(-2147483648), (_e21901 < -2147483600f)), 2147483647i, (_e21901 > 2147483500f)), (_e21901 == _e21901));
let _e21912 = (_e21908 - select(0i, 1i, (_e21901 < f32(_e21908))));
let _e21914 = select(-1f, _e21897, (_e21897 > -1f));
let _e21916 = select(1e6f, _e21914, (_e21914 < 1e6f));
let _e21923 = select(0i, select(select(i32(_e21916), i32(-2147483648), (_e21916 < -2147483600f)), 2147483647i, (_e21916 > 2147483500f)), (_e21916 == _e21916));
let _e21927 = (_e21923 - select(0i, 1i, (_e21916 < f32(_e21923))));
let _e21929 = (_e21895 - f32(_e21912));
let _e21931 = (_e21897 - f32(_e21927));
let _e21932 = (1f - _e21929);
let _e21933 = (1f - _e21931);
let _e21936 = select(_e21912, 0i, (_e21912 < 0i));
let _e21937 = (_e21936 >= _e21887.member);
if _e21937 {
phi_23132_ = (_e21887.member - 1i);
} else {
phi_23132_ = _e21936;
}
let _e21940 = phi_23132_;
let _e21942 = select(_e21927, 0i, (_e21927 < 0i));
let _e21943 = (_e21942 >= _e21887.member_1);
if _e21943 {
phi_23143_ = (_e21887.member_1 - 1i);
} else {
phi_23143_ = _e21942;
}
let _e21946 = phi_23143_;
let _e21950 = (((f32(_e21940) + 0.5f) * _e21892) - 0.5f);
let _e21954 = (((f32(_e21946) + 0.5f) * _e21892) - 0.5f);
if _e471 {
phi_23171_ = type_26(_e21946, _e21940);
} else {
phi_23171_ = type_26(_e21940, _e21946);
}
let _e21960 = phi_23171_;
let _e21963 = (_e19544 == 0u);
if _e21963 {
phi_23222_ = 0u;
} else {
if (_e19544 == 1u) {
phi_23221_ = 0u;
} else {
if (_e19544 == 2u) {
phi_23220_ = _e20613;
} else {
phi_23220_ = select(_e20619, _e20616, (_e19544 == 3u));
}
let _e21969 = phi_23220_;
phi_23221_ = _e21969;
}
let _e21971 = phi_23221_;
phi_23222_ = _e21971;
}
let _e21973 = phi_23222_;
local_160 = (((bitcast<i32>(_e21973) + _e21960.member_1) * _e20610) + _e21960.member);
let _e21978 = local_160;
let _e21980 = select(_e20636, _e21978, (_e21978 < _e20636));
let _e21985 = global_6.member[bitcast<u32>(select(0i, _e21980, (_e21980 > 0i)))];
let _e21990 = (((((select(_e21950, _e21954, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e21995 = ((1f - (((select(_e21954, _e21950, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e22002 = ((_e19765.member * _e21990) + (_e19773.member * _e21995));
let _e22003 = ((_e19765.member_1 * _e21990) + (_e19773.member_1 * _e21995));
let _e22004 = ((_e19765.member_2 * _e21990) + (_e19773.member_2 * _e21995));
let _e22008 = select((_e19788.member + _e22002), _e19788.member, _e19786);
let _e22009 = select((_e19788.member_1 + _e22003), _e19788.member_1, _e19786);
let _e22010 = select((_e19788.member_2 + _e22004), _e19788.member_2, _e19786);
let _e22021 = (((_e22008 * _e22008) + (_e22009 * _e22009)) + (_e22010 * _e22010));
let _e22025 = (1f / sqrt(select(0f, _e22021, (_e22021 > 0f))));
let _e22026 = (_e22008 * _e22025);
let _e22027 = (_e22009 * _e22025);
let _e22028 = (_e22010 * _e22025);
let _e22029 = (_e593 - select(_e19799.member, (_e19799.member + _e22002), _e19786));
let _e22030 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e22003), _e19786));
let _e22031 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e22004), _e19786));
let _e22036 = (((_e22029 * _e22026) + (_e22030 * _e22027)) + (_e22031 * _e22028));
let _e22041 = (((_e22029 * _e631) + (_e22030 * _e644)) + (_e22031 * _e657));
let _e22046 = (((_e22026 * _e631) + (_e22027 * _e644)) + (_e22028 * _e657));
let _e22049 = ((_e22027 * _e657) - (_e22028 * _e644));
let _e22052 = ((_e22028 * _e631) - (_e22026 * _e657));
let _e22055 = ((_e22026 * _e644) - (_e22027 * _e631));
let _e22060 = (((_e22049 * _e22049) + (_e22052 * _e22052)) + (_e22055 * _e22055));
let _e22063 = (1f / select(1e-9f, _e22060, (_e22060 > 1e-9f)));
let _e22066 = ((_e22036 - (_e22046 * _e22041)) * _e22063);
let _e22069 = (((_e22046 * _e22036) - _e22041) * _e22063);
let _e22075 = select(0f, _e22066, (((_e22069 >= 0f) && (_e22069 < _e709)) && (_e22066 > 0f)));
let _e22077 = (_e21940 << bitcast<u32>(_e21871));
let _e22089 = (_e21912 + 1i);
let _e22092 = select(_e22089, 0i, (_e22089 < 0i));
let _e22093 = (_e22092 >= _e21887.member);
if _e22093 {
phi_24206_ = (_e21887.member - 1i);
} else {
phi_24206_ = _e22092;
}
let _e22096 = phi_24206_;
if _e21943 {
phi_24217_ = (_e21887.member_1 - 1i);
} else {
phi_24217_ = _e21942;
}
let _e22099 = phi_24217_;
let _e22103 = (((f32(_e22096) + 0.5f) * _e21892) - 0.5f);
let _e22107 = (((f32(_e22099) + 0.5f) * _e21892) - 0.5f);
if _e471 {
phi_24245_ = type_26(_e22099, _e22096);
} else {
phi_24245_ = type_26(_e22096, _e22099);
}
let _e22113 = phi_24245_;
if _e21963 {
phi_24296_ = 0u;
} else {
if (_e19544 == 1u) {
phi_24295_ = 0u;
} else {
if (_e19544 == 2u) {
phi_24294_ = _e20613;
} else {
phi_24294_ = select(_e20619, _e20616, (_e19544 == 3u));
}
let _e22121 = phi_24294_;
phi_24295_ = _e22121;
}
let _e22123 = phi_24295_;
phi_24296_ = _e22123;
}
let _e22125 = phi_24296_;
local_158 = (((bitcast<i32>(_e22125) + _e22113.member_1) * _e20610) + _e22113.member);
let _e22130 = local_158;
let _e22132 = select(_e20636, _e22130, (_e22130 < _e20636));
let _e22137 = global_6.member[bitcast<u32>(select(0i, _e22132, (_e22132 > 0i)))];
let _e22142 = (((((select(_e22103, _e22107, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e22147 = ((1f - (((select(_e22107, _e22103, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e22154 = ((_e19765.member * _e22142) + (_e19773.member * _e22147));
let _e22155 = ((_e19765.member_1 * _e22142) + (_e19773.member_1 * _e22147));
let _e22156 = ((_e19765.member_2 * _e22142) + (_e19773.member_2 * _e22147));
let _e22160 = select((_e19788.member + _e22154), _e19788.member, _e19786);
let _e22161 = select((_e19788.member_1 + _e22155), _e19788.member_1, _e19786);
let _e22162 = select((_e19788.member_2 + _e22156), _e19788.member_2, _e19786);
let _e22173 = (((_e22160 * _e22160) + (_e22161 * _e22161)) + (_e22162 * _e22162));
let _e22177 = (1f / sqrt(select(0f, _e22173, (_e22173 > 0f))));
let _e22178 = (_e22160 * _e22177);
let _e22179 = (_e22161 * _e22177);
let _e22180 = (_e22162 * _e22177);
let _e22181 = (_e593 - select(_e19799.member, (_e19799.member + _e22154), _e19786));
let _e22182 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e22155), _e19786));
let _e22183 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e22156), _e19786));
let _e22188 = (((_e22181 * _e22178) + (_e22182 * _e22179)) + (_e22183 * _e22180));
let _e22193 = (((_e22181 * _e631) + (_e22182 * _e644)) + (_e22183 * _e657));
let _e22198 = (((_e22178 * _e631) + (_e22179 * _e644)) + (_e22180 * _e657));
let _e22201 = ((_e22179 * _e657) - (_e22180 * _e644));
let _e22204 = ((_e22180 * _e631) - (_e22178 * _e657));
let _e22207 = ((_e22178 * _e644) - (_e22179 * _e631));
let _e22212 = (((_e22201 * _e22201) + (_e22204 * _e22204)) + (_e22207 * _e22207));
let _e22215 = (1f / select(1e-9f, _e22212, (_e22212 > 1e-9f)));
let _e22218 = ((_e22188 - (_e22198 * _e22193)) * _e22215);
let _e22221 = (((_e22198 * _e22188) - _e22193) * _e22215);
let _e22227 = select(0f, _e22218, (((_e22221 >= 0f) && (_e22221 < _e709)) && (_e22218 > 0f)));
let _e22229 = (_e22096 << bitcast<u32>(_e21871));
let _e22241 = (_e21927 + 1i);
if _e21937 {
phi_25280_ = (_e21887.member - 1i);
} else {
phi_25280_ = _e21936;
}
let _e22245 = phi_25280_;
let _e22247 = select(_e22241, 0i, (_e22241 < 0i));
let _e22248 = (_e22247 >= _e21887.member_1);
if _e22248 {
phi_25291_ = (_e21887.member_1 - 1i);
} else {
phi_25291_ = _e22247;
}
let _e22251 = phi_25291_;
let _e22255 = (((f32(_e22245) + 0.5f) * _e21892) - 0.5f);
let _e22259 = (((f32(_e22251) + 0.5f) * _e21892) - 0.5f);
if _e471 {
phi_25319_ = type_26(_e22251, _e22245);
} else {
phi_25319_ = type_26(_e22245, _e22251);
}
let _e22265 = phi_25319_;
if _e21963 {
phi_25370_ = 0u;
} else {
if (_e19544 == 1u) {
phi_25369_ = 0u;
} else {
if (_e19544 == 2u) {
phi_25368_ = _e20613;
} else {
phi_25368_ = select(_e20619, _e20616, (_e19544 == 3u));
}
let _e22273 = phi_25368_;
phi_25369_ = _e22273;
}
let _e22275 = phi_25369_;
phi_25370_ = _e22275;
}
let _e22277 = phi_25370_;
local_156 = (((bitcast<i32>(_e22277) + _e22265.member_1) * _e20610) + _e22265.member);
let _e22282 = local_156;
let _e22284 = select(_e20636, _e22282, (_e22282 < _e20636));
let _e22289 = global_6.member[bitcast<u32>(select(0i, _e22284, (_e22284 > 0i)))];
let _e22294 = (((((select(_e22255, _e22259, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e22299 = ((1f - (((select(_e22259, _e22255, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e22306 = ((_e19765.member * _e22294) + (_e19773.member * _e22299));
let _e22307 = ((_e19765.member_1 * _e22294) + (_e19773.member_1 * _e22299));
let _e22308 = ((_e19765.member_2 * _e22294) + (_e19773.member_2 * _e22299));
let _e22312 = select((_e19788.member + _e22306), _e19788.member, _e19786);
let _e22313 = select((_e19788.member_1 + _e22307), _e19788.member_1, _e19786);
let _e22314 = select((_e19788.member_2 + _e22308), _e19788.member_2, _e19786);
let _e22325 = (((_e22312 * _e22312) + (_e22313 * _e22313)) + (_e22314 * _e22314));
let _e22329 = (1f / sqrt(select(0f, _e22325, (_e22325 > 0f))));
let _e22330 = (_e22312 * _e22329);
let _e22331 = (_e22313 * _e22329);
let _e22332 = (_e22314 * _e22329);
let _e22333 = (_e593 - select(_e19799.member, (_e19799.member + _e22306), _e19786));
let _e22334 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e22307), _e19786));
let _e22335 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e22308), _e19786));
let _e22340 = (((_e22333 * _e22330) + (_e22334 * _e22331)) + (_e22335 * _e22332));
let _e22345 = (((_e22333 * _e631) + (_e22334 * _e644)) + (_e22335 * _e657));
let _e22350 = (((_e22330 * _e631) + (_e22331 * _e644)) + (_e22332 * _e657));
let _e22353 = ((_e22331 * _e657) - (_e22332 * _e644));
let _e22356 = ((_e22332 * _e631) - (_e22330 * _e657));
let _e22359 = ((_e22330 * _e644) - (_e22331 * _e631));
let _e22364 = (((_e22353 * _e22353) + (_e22356 * _e22356)) + (_e22359 * _e22359));
let _e22367 = (1f / select(1e-9f, _e22364, (_e22364 > 1e-9f)));
let _e22370 = ((_e22340 - (_e22350 * _e22345)) * _e22367);
let _e22373 = (((_e22350 * _e22340) - _e22345) * _e22367);
let _e22379 = select(0f, _e22370, (((_e22373 >= 0f) && (_e22373 < _e709)) && (_e22370 > 0f)));
let _e22381 = (_e22245 << bitcast<u32>(_e21871));
if _e22093 {
phi_26354_ = (_e21887.member - 1i);
} else {
phi_26354_ = _e22092;
}
let _e22396 = phi_26354_;
if _e22248 {
phi_26365_ = (_e21887.member_1 - 1i);
} else {
phi_26365_ = _e22247;
}
let _e22399 = phi_26365_;
let _e22403 = (((f32(_e22396) + 0.5f) * _e21892) - 0.5f);
let _e22407 = (((f32(_e22399) + 0.5f) * _e21892) - 0.5f);
if _e471 {
phi_26393_ = type_26(_e22399, _e22396);
} else {
phi_26393_ = type_26(_e22396, _e22399);
}
let _e22413 = phi_26393_;
if _e21963 {
phi_26444_ = 0u;
} else {
if (_e19544 == 1u) {
phi_26443_ = 0u;
} else {
if (_e19544 == 2u) {
phi_26442_ = _e20613;
} else {
phi_26442_ = select(_e20619, _e20616, (_e19544 == 3u));
}
let _e22421 = phi_26442_;
phi_26443_ = _e22421;
}
let _e22423 = phi_26443_;
phi_26444_ = _e22423;
}
let _e22425 = phi_26444_;
local_154 = (((bitcast<i32>(_e22425) + _e22413.member_1) * _e20610) + _e22413.member);
let _e22430 = local_154;
let _e22432 = select(_e20636, _e22430, (_e22430 < _e20636));
let _e22437 = global_6.member[bitcast<u32>(select(0i, _e22432, (_e22432 > 0i)))];
let _e22442 = (((((select(_e22403, _e22407, _e471) + 0.5f) / _e19746) * 2f) - 1f) * _e19754);
let _e22447 = ((1f - (((select(_e22407, _e22403, _e471) + 0.5f) / _e19747) * 2f)) * _e19762);
let _e22454 = ((_e19765.member * _e22442) + (_e19773.member * _e22447));
let _e22455 = ((_e19765.member_1 * _e22442) + (_e19773.member_1 * _e22447));
let _e22456 = ((_e19765.member_2 * _e22442) + (_e19773.member_2 * _e22447));
let _e22460 = select((_e19788.member + _e22454), _e19788.member, _e19786);
let _e22461 = select((_e19788.member_1 + _e22455), _e19788.member_1, _e19786);
let _e22462 = select((_e19788.member_2 + _e22456), _e19788.member_2, _e19786);
let _e22473 = (((_e22460 * _e22460) + (_e22461 * _e22461)) + (_e22462 * _e22462));
let _e22477 = (1f / sqrt(select(0f, _e22473, (_e22473 > 0f))));
let _e22478 = (_e22460 * _e22477);
let _e22479 = (_e22461 * _e22477);
let _e22480 = (_e22462 * _e22477);
let _e22481 = (_e593 - select(_e19799.member, (_e19799.member + _e22454), _e19786));
let _e22482 = (_e605 - select(_e19799.member_1, (_e19799.member_1 + _e22455), _e19786));
let _e22483 = (_e618 - select(_e19799.member_2, (_e19799.member_2 + _e22456), _e19786));
let _e22488 = (((_e22481 * _e22478) + (_e22482 * _e22479)) + (_e22483 * _e22480));
let _e22493 = (((_e22481 * _e631) + (_e22482 * _e644)) + (_e22483 * _e657));
let _e22498 = (((_e22478 * _e631) + (_e22479 * _e644)) + (_e22480 * _e657));
let _e22501 = ((_e22479 * _e657) - (_e22480 * _e644));
let _e22504 = ((_e22480 * _e631) - (_e22478 * _e657));
let _e22507 = ((_e22478 * _e644) - (_e22479 * _e631));
let _e22512 = (((_e22501 * _e22501) + (_e22504 * _e22504)) + (_e22507 * _e22507));
let _e22515 = (1f / select(1e-9f, _e22512, (_e22512 > 1e-9f)));
let _e22518 = ((_e22488 - (_e22498 * _e22493)) * _e22515);
let _e22521 = (((_e22498 * _e22488) - _e22493) * _e22515);
let _e22527 = select(0f, _e22518, (((_e22521 >= 0f) && (_e22521 < _e709)) && (_e22518 > 0f)));
let _e22529 = (_e22396 << bitcast<u32>(_e21871));
let _e22541 = select(((((_e21870 - select(0f, (_e21932 * _e21933), (((select(select(_e784, _e941, (_e22077 >= _e710)), _e863, (_e22077 < _e316)) == _e19544) && (_e22075 > 0f)) && (_e22075 < _e21985)))) - select(0f, (_e21929 * _e21933), (((select(select(_e784, _e941, (_e22229 >= _e710)), _e863, (_e22229 < _e316)) == _e19544) && (_e22227 > 0f)) && (_e22227 < _e22137)))) - select(0f, (_e21932 * _e21931), (((select(select(_e784, _e941, (_e22381 >= _e710)), _e863, (_e22381 < _e316)) == _e19544) && (_e22379 > 0f)) && (_e22379 < _e22289)))) - select(0f, (_e21929 * _e21931), (((select(select(_e784, _e941, (_e22529 >= _e710)), _e863, (_e22529 < _e316)) == _e19544) && (_e22527 > 0f)) && (_e22527 < _e22437)))), _e21870, _e21963);
if _e471 {
phi_27437_ = type_26(_e19651, _e19559);
} else {
phi_27437_ = type_26(_e19559, _e19651);
}
let _e22556 = phi_27437_;
let _e22559 = (_e19652 && (((_e20514 > 0f) && (_e20514 < _e19742)) && (bitcast<f32>((bitcast<u32>(_e22541) & 2147483647u)) > 1e-6f)));
let _e22562 = global_1.member.member_18.member;
let _e22563 = (((select(_e19677, (1f - _e19677), (_e19662 >= 0f)) - select(_e19696, (1f - _e19696), (_e19681 >= 0f))) * (1f / _e19659)) * _e22562);
let _e22567 = select(0f, (((((_e670 * _e20501.member) * ((1f + (_e20382 * (1f + (_e20382 * (0.5f + (_e20382 * (0.16666667f + (_e20382 * (0.041666668f + (_e20382 * (0.008333334f + (_e20382 * (0.001388889f + (_e20382 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20377 + 127i)) << bitcast<u32>(23i))))) * _e20204) * _e22541) * _e22563), _e22559);
let _e22568 = select(0f, (((((_e683 * _e20501.member_1) * ((1f + (_e20430 * (1f + (_e20430 * (0.5f + (_e20430 * (0.16666667f + (_e20430 * (0.041666668f + (_e20430 * (0.008333334f + (_e20430 * (0.001388889f + (_e20430 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20425 + 127i)) << bitcast<u32>(23i))))) * _e20204) * _e22541) * _e22563), _e22559);
let _e22569 = select(0f, (((((_e696 * _e20501.member_2) * ((1f + (_e20478 * (1f + (_e20478 * (0.5f + (_e20478 * (0.16666667f + (_e20478 * (0.041666668f + (_e20478 * (0.008333334f + (_e20478 * (0.001388889f + (_e20478 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20473 + 127i)) << bitcast<u32>(23i))))) * _e20204) * _e22541) * _e22563), _e22559);
let _e22573 = (bitcast<f32>((bitcast<u32>(_e22567) & 2147483647u)) >= 1073741800f);
let _e22574 = (1f / 1048576f);
let _e22577 = ((_e22567 * select(1f, _e22574, _e22573)) + 0.5f);
let _e22579 = select(-1073741800f, _e22577, (_e22577 > -1073741800f));
let _e22581 = select(1073741800f, _e22579, (_e22579 < 1073741800f));
let _e22588 = select(0i, select(select(i32(_e22581), i32(-2147483648), (_e22581 < -2147483600f)), 2147483647i, (_e22581 > 2147483500f)), (_e22581 == _e22581));
let _e22592 = (_e22588 - select(0i, 1i, (_e22581 < f32(_e22588))));
let _e22593 = select(0i, 20i, _e22573);
let _e22597 = (bitcast<u32>(_e22592) << bitcast<u32>((_e22593 & 31i)));
let _e22604 = bitcast<u32>(((_e22592 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22593) & 31i))));
let _e22608 = (bitcast<f32>((bitcast<u32>(_e22568) & 2147483647u)) >= 1073741800f);
let _e22611 = ((_e22568 * select(1f, _e22574, _e22608)) + 0.5f);
let _e22613 = select(-1073741800f, _e22611, (_e22611 > -1073741800f));
let _e22615 = select(1073741800f, _e22613, (_e22613 < 1073741800f));
let _e22622 = select(0i, select(select(i32(_e22615), i32(-2147483648), (_e22615 < -2147483600f)), 2147483647i, (_e22615 > 2147483500f)), (_e22615 == _e22615));
let _e22626 = (_e22622 - select(0i, 1i, (_e22615 < f32(_e22622))));
let _e22627 = select(0i, 20i, _e22608);
let _e22631 = (bitcast<u32>(_e22626) << bitcast<u32>((_e22627 & 31i)));
let _e22638 = bitcast<u32>(((_e22626 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22627) & 31i))));
let _e22642 = (bitcast<f32>((bitcast<u32>(_e22569) & 2147483647u)) >= 1073741800f);
let _e22645 = ((_e22569 * select(1f, _e22574, _e22642)) + 0.5f);
let _e22647 = select(-1073741800f, _e22645, (_e22645 > -1073741800f));
let _e22649 = select(1073741800f, _e22647, (_e22647 < 1073741800f));
let _e22656 = select(0i, select(select(i32(_e22649), i32(-2147483648), (_e22649 < -2147483600f)), 2147483647i, (_e22649 > 2147483500f)), (_e22649 == _e22649));
let _e22660 = (_e22656 - select(0i, 1i, (_e22649 < f32(_e22656))));
let _e22661 = select(0i, 20i, _e22642);
let _e22665 = (bitcast<u32>(_e22660) << bitcast<u32>((_e22661 & 31i)));
let _e22672 = bitcast<u32>(((_e22660 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22661) & 31i))));
let _e22677 = bitcast<i32>(bitcast<u32>((((_e22556.member_1 * _e11931) + _e22556.member) * 6i)));
if ((_e22597 | _e22604) == 0u) {
} else {
let _e22680 = bitcast<u32>(_e22677);
if (_e22680 < _e288) {
let _e22684 = atomicAdd((&global_8.member[_e22680]), _e22597);
phi_27670_ = _e22684;
} else {
phi_27670_ = 0u;
}
let _e22686 = phi_27670_;
let _e22690 = (_e22604 + select(0u, 1u, ((_e22686 + _e22597) < _e22597)));
if (_e22690 == 0u) {
} else {
let _e22692 = (_e22680 + 1u);
if (_e22692 < _e288) {
let _e22696 = atomicAdd((&global_8.member[_e22692]), _e22690);
}
}
}
if ((_e22631 | _e22638) == 0u) {
} else {
let _e22700 = bitcast<u32>((_e22677 + 2i));
if (_e22700 < _e288) {
let _e22704 = atomicAdd((&global_8.member[_e22700]), _e22631);
phi_27700_ = _e22704;
} else {
phi_27700_ = 0u;
}
let _e22706 = phi_27700_;
let _e22710 = (_e22638 + select(0u, 1u, ((_e22706 + _e22631) < _e22631)));
if (_e22710 == 0u) {
} else {
let _e22712 = (_e22700 + 1u);
if (_e22712 < _e288) {
let _e22716 = atomicAdd((&global_8.member[_e22712]), _e22710);
}
}
}
if ((_e22665 | _e22672) == 0u) {
} else {
let _e22720 = bitcast<u32>((_e22677 + 4i));
if (_e22720 < _e288) {
let _e22724 = atomicAdd((&global_8.member[_e22720]), _e22665);
phi_27730_ = _e22724;
} else {
phi_27730_ = 0u;
}
let _e22726 = phi_27730_;
let _e22730 = (_e22672 + select(0u, 1u, ((_e22726 + _e22665) < _e22665)));
if (_e22730 == 0u) {
} else {
let _e22732 = (_e22720 + 1u);
if (_e22732 < _e288) {
let _e22736 = atomicAdd((&global_8.member[_e22732]), _e22730);
}
}
}
phi_12861_ = (_e19649 + 1i);
} else {
phi_12861_ = i32();
}
let _e22739 = phi_12861_;
continue;
continuing {
phi_12860_ = _e22739;
break if !(_e19652);
}
}
phi_12707_ = (_e19556 + 1i);
} else {
phi_12707_ = i32();
}
let _e22743 = phi_12707_;
continue;
continuing {
phi_12706_ = _e22743;
break if !(_e19557);
}
}
}
}
} else {
let _e11983 = (_e784 & 31u);
let _e11985 = (1u << bitcast<u32>(_e11983));
let _e11994 = bitcast<i32>((((_e11927 + _e11985) - 1u) >> bitcast<u32>(_e11983)));
let _e11995 = bitcast<i32>((((_e11930 + _e11985) - 1u) >> bitcast<u32>(_e11983)));
if _e471 {
phi_27796_ = type_26(_e11995, _e11994);
} else {
phi_27796_ = type_26(_e11994, _e11995);
}
let _e11999 = phi_27796_;
let _e12003 = (_e11957 >> bitcast<u32>(_e11983));
if (_e12003 < _e11999.member) {
phi_27871_ = _e12003;
} else {
phi_27871_ = (_e11999.member - 1i);
}
let _e12009 = phi_27871_;
phi_27875_ = type_26(2147483647i, -1i);
phi_27878_ = 0i;
loop {
let _e12012 = phi_27875_;
let _e12014 = phi_27878_;
local_243 = _e12012;
local_244 = _e12012;
let _e12015 = (_e12014 < 16i);
if _e12015 {
let _e12017 = (1i << bitcast<u32>(_e11983));
let _e12018 = f32(_e12017);
let _e12020 = ((4u - _e784) & 31u);
let _e12025 = ((_e11975 >> bitcast<u32>(_e11983)) + (_e12014 & ((1i << bitcast<u32>(_e12020)) - 1i)));
let _e12029 = (((f32(_e12025) + 0.5f) * _e12018) - 0.5f);
let _e12033 = (-(((_e434 * _e12029) + _e460)) / _e447);
let _e12040 = bitcast<f32>((bitcast<u32>(((_e484 * _e12029) + ((_e497 * _e12033) + _e510))) & 2147483647u));
let _e12047 = bitcast<f32>((bitcast<u32>(((_e523 * _e12029) + ((_e536 * _e12033) + _e549))) & 2147483647u));
let _e12052 = (((0.5f * (_e12040 + _e12047)) / _e552) + (0.5f * _e12018));
let _e12053 = (1f / _e12018);
let _e12061 = ((((_e12033 + _e12052) + 0.5f) * _e12053) - 0.5f);
let _e12062 = f32((_e11999.member_1 - 1i));
let _e12063 = (0f - 1f);
let _e12065 = select(_e12063, _e12061, (_e12061 > _e12063));
let _e12067 = select(_e12062, _e12065, (_e12065 < _e12062));
let _e12074 = select(0i, select(select(i32(_e12067), i32(-2147483648), (_e12067 < -2147483600f)), 2147483647i, (_e12067 > 2147483500f)), (_e12067 == _e12067));
let _e12079 = (((((_e12033 - _e12052) + 0.5f) * _e12053) - 0.5f) + 1f);
let _e12080 = (_e12062 + 1f);
let _e12082 = select(0f, _e12079, (_e12079 > 0f));
let _e12084 = select(_e12080, _e12082, (_e12082 < _e12080));
let _e12091 = select(0i, select(select(i32(_e12084), i32(-2147483648), (_e12084 < -2147483600f)), 2147483647i, (_e12084 > 2147483500f)), (_e12084 == _e12084));
let _e12102 = ((1e-4f * _e12018) * _e552);
let _e12104 = select(_e12047, _e12040, (_e12040 > _e12047));
let _e12106 = select(_e12102, _e12104, (_e12104 > _e12102));
let _e12108 = select(_e12047, _e12040, (_e12040 < _e12047));
let _e12110 = select(_e12102, _e12108, (_e12108 > _e12102));
let _e12112 = (0.5f * (_e12106 + _e12110));
let _e12113 = (0.5f / _e12110);
let _e12114 = (1f / _e12106);
phi_28029_ = _e12012;
phi_28032_ = 0i;
loop {
let _e12116 = phi_28029_;
let _e12118 = phi_28032_;
local_255 = _e12116;
let _e12121 = (((_e12091 - select(0i, 1i, (_e12084 < f32(_e12091)))) + (_e12014 >> bitcast<u32>(_e12020))) + (_e12118 << bitcast<u32>(_e11983)));
let _e12122 = (_e12121 <= select(-1i, (_e12074 - select(0i, 1i, (_e12067 < f32(_e12074)))), (_e12025 <= _e12009)));
if _e12122 {
let _e12126 = (((f32(_e12121) + 0.5f) * _e12018) - 0.5f);
let _e12128 = ((_e12126 - _e12033) * _e552);
let _e12129 = (_e552 * _e12018);
let _e12131 = (0.5f * _e12129);
let _e12132 = (_e12128 + _e12131);
let _e12133 = -(_e12132);
let _e12136 = (_e12112 - select(_e12133, _e12132, (_e12132 > _e12133)));
let _e12138 = select(0f, _e12136, (_e12136 > 0f));
let _e12140 = select(_e12110, _e12138, (_e12138 < _e12110));
let _e12143 = (_e12136 - _e12110);
let _e12147 = (((_e12140 * (_e12140 * _e12113)) + select(0f, _e12143, (_e12143 > 0f))) * _e12114);
let _e12151 = (_e12128 - _e12131);
let _e12152 = -(_e12151);
let _e12155 = (_e12112 - select(_e12152, _e12151, (_e12151 > _e12152)));
let _e12157 = select(0f, _e12155, (_e12155 > 0f));
let _e12159 = select(_e12110, _e12157, (_e12157 < _e12110));
let _e12162 = (_e12155 - _e12110);
let _e12166 = (((_e12159 * (_e12159 * _e12113)) + select(0f, _e12162, (_e12162 > 0f))) * _e12114);
if _e471 {
phi_28162_ = type_26(_e12121, _e12025);
} else {
phi_28162_ = type_26(_e12025, _e12121);
}
let _e12177 = phi_28162_;
let _e12183 = bitcast<i32>(((_e11927 + 1u) >> bitcast<u32>(1u)));
let _e12186 = global_1.member.member_18.member_9;
let _e12191 = global_1.member.member_18.member_6;
let _e12194 = global_1.member.member_18.member_7;
let _e12197 = global_1.member.member_18.member_8;
if _e11982 {
phi_28213_ = 0u;
} else {
if (_e784 == 1u) {
phi_28212_ = 0u;
} else {
if (_e784 == 2u) {
phi_28211_ = _e12191;
} else {
phi_28211_ = select(_e12197, _e12194, (_e784 == 3u));
}
let _e12203 = phi_28211_;
phi_28212_ = _e12203;
}
let _e12205 = phi_28212_;
phi_28213_ = _e12205;
}
let _e12207 = phi_28213_;
local_152 = (((bitcast<i32>(_e12207) + _e12177.member_1) * _e12183) + _e12177.member);
local_153 = (_e12183 * bitcast<i32>(_e12186));
let _e12212 = local_152;
let _e12214 = (bitcast<i32>(_e280) - 1i);
let _e12216 = select(_e12214, _e12212, (_e12212 < _e12214));
let _e12221 = global_6.member[bitcast<u32>(select(0i, _e12216, (_e12216 > 0i)))];
let _e12222 = local_153;
let _e12223 = local_152;
let _e12224 = (_e12222 + _e12223);
let _e12226 = select(_e12214, _e12224, (_e12224 < _e12214));
let _e12231 = global_6.member[bitcast<u32>(select(0i, _e12226, (_e12226 > 0i)))];
let _e12232 = local_153;
let _e12234 = local_152;
let _e12235 = ((2i * _e12232) + _e12234);
let _e12237 = select(_e12214, _e12235, (_e12235 < _e12214));
let _e12242 = global_6.member[bitcast<u32>(select(0i, _e12237, (_e12237 > 0i)))];
let _e12244 = (_e12017 >> bitcast<u32>(1i));
let _e12247 = ((_e12177.member << bitcast<u32>(_e11983)) + _e12244);
let _e12250 = ((_e12177.member_1 << bitcast<u32>(_e11983)) + _e12244);
let _e12252 = select(_e12247, 0i, (_e12247 < 0i));
if (_e12252 >= _e11931) {
phi_28339_ = (_e11931 - 1i);
} else {
phi_28339_ = _e12252;
}
let _e12256 = phi_28339_;
let _e12258 = select(_e12250, 0i, (_e12250 < 0i));
if (_e12258 >= _e11932) {
phi_28350_ = (_e11932 - 1i);
} else {
phi_28350_ = _e12258;
}
let _e12262 = phi_28350_;
let _e12264 = bitcast<i32>((_e11927 * _e11930));
local_150 = _e12264;
local_151 = ((_e12262 * _e11931) + _e12256);
let _e12267 = local_150;
let _e12268 = local_151;
let _e12269 = (_e12267 + _e12268);
let _e12271 = (bitcast<i32>(_e277) - 1i);
let _e12273 = select(_e12271, _e12269, (_e12269 < _e12271));
let _e12278 = global_5.member[bitcast<u32>(select(0i, _e12273, (_e12273 > 0i)))];
let _e12279 = local_150;
let _e12281 = local_151;
let _e12282 = ((2i * _e12279) + _e12281);
let _e12284 = select(_e12271, _e12282, (_e12282 < _e12271));
let _e12289 = global_5.member[bitcast<u32>(select(0i, _e12284, (_e12284 > 0i)))];
let _e12290 = local_151;
let _e12299 = global_1.member.member_2.member;
let _e12300 = (((((select(_e12029, _e12126, _e471) + 0.5f) / f32(_e11931)) * 2f) - 1f) * _e12299);
let _e12307 = global_1.member.member_2.member_1;
let _e12308 = ((1f - (((select(_e12126, _e12029, _e471) + 0.5f) / f32(_e11932)) * 2f)) * _e12307);
let _e12310 = global_1.member.member_3;
let _e12318 = global_1.member.member_4;
let _e12325 = ((_e12310.member * _e12300) + (_e12318.member * _e12308));
let _e12326 = ((_e12310.member_1 * _e12300) + (_e12318.member_1 * _e12308));
let _e12327 = ((_e12310.member_2 * _e12300) + (_e12318.member_2 * _e12308));
let _e12330 = global_1.member.member_2.member_3;
let _e12331 = (_e12330 != 0u);
let _e12333 = global_1.member.member_5;
let _e12340 = select((_e12333.member + _e12325), _e12333.member, _e12331);
let _e12341 = select((_e12333.member_1 + _e12326), _e12333.member_1, _e12331);
let _e12342 = select((_e12333.member_2 + _e12327), _e12333.member_2, _e12331);
let _e12344 = global_1.member.member_6;
let _e12351 = select(_e12344.member, (_e12344.member + _e12325), _e12331);
let _e12352 = select(_e12344.member_1, (_e12344.member_1 + _e12326), _e12331);
let _e12353 = select(_e12344.member_2, (_e12344.member_2 + _e12327), _e12331);
let _e12358 = (((_e12340 * _e12340) + (_e12341 * _e12341)) + (_e12342 * _e12342));
let _e12361 = sqrt(select(0f, _e12358, (_e12358 > 0f)));
let _e12362 = (1f / _e12361);
let _e12363 = (_e12340 * _e12362);
let _e12364 = (_e12341 * _e12362);
let _e12365 = (_e12342 * _e12362);
let _e12366 = (_e593 - _e12351);
let _e12367 = (_e605 - _e12352);
let _e12368 = (_e618 - _e12353);
let _e12373 = (((_e12366 * _e12363) + (_e12367 * _e12364)) + (_e12368 * _e12365));
let _e12378 = (((_e12366 * _e631) + (_e12367 * _e644)) + (_e12368 * _e657));
let _e12383 = (((_e12363 * _e631) + (_e12364 * _e644)) + (_e12365 * _e657));
let _e12386 = ((_e12364 * _e657) - (_e12365 * _e644));
let _e12389 = ((_e12365 * _e631) - (_e12363 * _e657));
let _e12392 = ((_e12363 * _e644) - (_e12364 * _e631));
let _e12397 = (((_e12386 * _e12386) + (_e12389 * _e12389)) + (_e12392 * _e12392));
let _e12400 = (1f / select(1e-9f, _e12397, (_e12397 > 1e-9f)));
let _e12403 = ((_e12373 - (_e12383 * _e12378)) * _e12400);
let _e12406 = (((_e12383 * _e12373) - _e12378) * _e12400);
let _e12412 = -(_e12383);
let _e12415 = global_1.member.member_13.member_2;
let _e12416 = (_e12415 * _e12415);
let _e12420 = ((1f + _e12416) - ((2f * _e12415) * _e12412));
let _e12422 = select(1e-9f, _e12420, (_e12420 > 1e-9f));
let _e12434 = global_1.member.member_13.member_3;
if (_e12434 == 2u) {
let _e12439 = (0.5f - (0.5f * _e12412));
let _e12441 = select(0f, _e12439, (_e12439 > 0f));
let _e12445 = (sqrt(select(0f, _e12441, (_e12441 > 0f))) * 255f);
let _e12446 = (255f - 1f);
let _e12448 = select(0f, _e12445, (_e12445 > 0f));
let _e12450 = select(_e12446, _e12448, (_e12448 < _e12446));
let _e12457 = select(0i, select(select(i32(_e12450), i32(-2147483648), (_e12450 < -2147483600f)), 2147483647i, (_e12450 > 2147483500f)), (_e12450 == _e12450));
let _e12461 = (_e12457 - select(0i, 1i, (_e12450 < f32(_e12457))));
let _e12464 = global_1.member.member_13.member_11;
let _e12465 = bitcast<i32>(_e12464);
let _e12466 = (_e12465 + _e12461);
let _e12468 = (bitcast<i32>(_e283) - 1i);
let _e12470 = select(_e12468, _e12466, (_e12466 < _e12468));
let _e12475 = global_2.member[bitcast<u32>(select(0i, _e12470, (_e12470 > 0i)))];
let _e12477 = (_e12465 + (_e12461 + 1i));
let _e12479 = select(_e12468, _e12477, (_e12477 < _e12468));
let _e12484 = global_2.member[bitcast<u32>(select(0i, _e12479, (_e12479 > 0i)))];
phi_28773_ = (_e12475 + ((_e12484 - _e12475) * (_e12445 - f32(_e12461))));
} else {
phi_28773_ = select(((1f - _e12416) / (_e12422 * sqrt(select(0f, _e12422, (_e12422 > 0f))))), (0.75f * (1f + (_e12412 * _e12412))), (_e12434 == 1u));
}
let _e12491 = phi_28773_;
let _e12503 = global_1.member.member_13.member_7;
let _e12504 = bitcast<i32>(_e12503);
let _e12507 = global_1.member.member_13.member_8;
let _e12508 = bitcast<i32>(_e12507);
let _e12511 = global_1.member.member_13.member_9;
let _e12512 = bitcast<i32>(_e12511);
let _e12515 = global_1.member.member_13.member_4;
let _e12521 = global_1.member.member_13.member_5;
let _e12525 = f32(_e12504);
let _e12530 = (((((_e12351 + (_e12363 * _e12403)) - _e12515.member) / (_e12521.member - _e12515.member)) * _e12525) - 0.5f);
let _e12531 = (_e12525 - 1f);
let _e12533 = select(0f, _e12530, (_e12530 > 0f));
let _e12535 = select(_e12531, _e12533, (_e12533 < _e12531));
let _e12536 = f32(_e12508);
let _e12541 = (((((_e12352 + (_e12364 * _e12403)) - _e12515.member_1) / (_e12521.member_1 - _e12515.member_1)) * _e12536) - 0.5f);
let _e12542 = (_e12536 - 1f);
let _e12544 = select(0f, _e12541, (_e12541 > 0f));
let _e12546 = select(_e12542, _e12544, (_e12544 < _e12542));
let _e12547 = f32(_e12512);
let _e12552 = (((((_e12353 + (_e12365 * _e12403)) - _e12515.member_2) / (_e12521.member_2 - _e12515.member_2)) * _e12547) - 0.5f);
let _e12553 = (_e12547 - 1f);
let _e12555 = select(0f, _e12552, (_e12552 > 0f));
let _e12557 = select(_e12553, _e12555, (_e12555 < _e12553));
let _e12559 = select(0f, _e12535, (_e12535 > 0f));
let _e12561 = select(1e6f, _e12559, (_e12559 < 1e6f));
let _e12568 = select(0i, select(select(i32(_e12561), i32(-2147483648), (_e12561 < -2147483600f)), 2147483647i, (_e12561 > 2147483500f)), (_e12561 == _e12561));
let _e12572 = (_e12568 - select(0i, 1i, (_e12561 < f32(_e12568))));
let _e12574 = select(0f, _e12546, (_e12546 > 0f));
let _e12576 = select(1e6f, _e12574, (_e12574 < 1e6f));
let _e12583 = select(0i, select(select(i32(_e12576), i32(-2147483648), (_e12576 < -2147483600f)), 2147483647i, (_e12576 > 2147483500f)), (_e12576 == _e12576));
let _e12587 = (_e12583 - select(0i, 1i, (_e12576 < f32(_e12583))));
let _e12589 = select(0f, _e12557, (_e12557 > 0f));
let _e12591 = select(1e6f, _e12589, (_e12589 < 1e6f));
let _e12598 = select(0i, select(select(i32(_e12591), i32(-2147483648), (_e12591 < -2147483600f)), 2147483647i, (_e12591 > 2147483500f)), (_e12591 == _e12591));
let _e12602 = (_e12598 - select(0i, 1i, (_e12591 < f32(_e12598))));
let _e12606 = (_e12546 - f32(_e12587));
let _e12608 = (_e12557 - f32(_e12602));
local_148 = (_e12535 - f32(_e12572));
let _e12609 = (_e12572 + 1i);
let _e12611 = select(_e12609, 0i, (_e12609 < 0i));
if (_e12611 >= _e12504) {
phi_28905_ = (_e12504 - 1i);
} else {
phi_28905_ = _e12611;
}
let _e12615 = phi_28905_;
local_149 = (_e12615 - _e12572);
let _e12617 = (_e12587 + 1i);
let _e12619 = select(_e12617, 0i, (_e12617 < 0i));
if (_e12619 >= _e12508) {
phi_28918_ = (_e12508 - 1i);
} else {
phi_28918_ = _e12619;
}
let _e12623 = phi_28918_;
let _e12625 = ((_e12623 - _e12587) * _e12504);
let _e12626 = (_e12602 + 1i);
let _e12628 = select(_e12626, 0i, (_e12626 < 0i));
if (_e12628 >= _e12512) {
phi_28932_ = (_e12512 - 1i);
} else {
phi_28932_ = _e12628;
}
let _e12632 = phi_28932_;
let _e12638 = global_1.member.member_13.member_10;
let _e12644 = ((bitcast<i32>(_e12638) + (((_e12602 * _e12508) + _e12587) * _e12504)) + _e12572);
let _e12646 = (bitcast<i32>(_e283) - 1i);
let _e12648 = select(_e12646, _e12644, (_e12644 < _e12646));
let _e12653 = global_2.member[bitcast<u32>(select(0i, _e12648, (_e12648 > 0i)))];
let _e12654 = local_148;
let _e12657 = local_149;
let _e12658 = (_e12644 + _e12657);
let _e12660 = select(_e12646, _e12658, (_e12658 < _e12646));
let _e12665 = global_2.member[bitcast<u32>(select(0i, _e12660, (_e12660 > 0i)))];
let _e12666 = local_148;
let _e12669 = (1f - _e12606);
let _e12671 = (_e12644 + _e12625);
let _e12673 = select(_e12646, _e12671, (_e12671 < _e12646));
let _e12678 = global_2.member[bitcast<u32>(select(0i, _e12673, (_e12673 > 0i)))];
let _e12679 = local_148;
let _e12682 = local_149;
let _e12683 = (_e12671 + _e12682);
let _e12685 = select(_e12646, _e12683, (_e12683 < _e12646));
let _e12690 = global_2.member[bitcast<u32>(select(0i, _e12685, (_e12685 > 0i)))];
let _e12691 = local_148;
let _e12696 = (_e12644 + (((_e12632 - _e12602) * _e12504) * _e12508));
let _e12698 = select(_e12646, _e12696, (_e12696 < _e12646));
let _e12703 = global_2.member[bitcast<u32>(select(0i, _e12698, (_e12698 > 0i)))];
let _e12704 = local_148;
let _e12707 = local_149;
let _e12708 = (_e12696 + _e12707);
let _e12710 = select(_e12646, _e12708, (_e12708 < _e12646));
let _e12715 = global_2.member[bitcast<u32>(select(0i, _e12710, (_e12710 > 0i)))];
let _e12716 = local_148;
let _e12720 = (_e12696 + _e12625);
let _e12722 = select(_e12646, _e12720, (_e12720 < _e12646));
let _e12727 = global_2.member[bitcast<u32>(select(0i, _e12722, (_e12722 > 0i)))];
let _e12728 = local_148;
let _e12731 = local_149;
let _e12732 = (_e12720 + _e12731);
let _e12734 = select(_e12646, _e12732, (_e12732 < _e12646));
let _e12739 = global_2.member[bitcast<u32>(select(0i, _e12734, (_e12734 > 0i)))];
let _e12740 = local_148;
let _e12749 = ((_e12361 * (_e12491 * (0.25f / 3.1415927f))) * ((((((_e12653 * (1f - _e12654)) + (_e12665 * _e12666)) * _e12669) + (((_e12678 * (1f - _e12679)) + (_e12690 * _e12691)) * _e12606)) * (1f - _e12608)) + (((((_e12703 * (1f - _e12704)) + (_e12715 * _e12716)) * _e12669) + (((_e12727 * (1f - _e12728)) + (_e12739 * _e12740)) * _e12606)) * _e12608)));
let _e12752 = global_1.member.member_12.member_12;
let _e12755 = global_1.member.member_12.member_4;
let _e12758 = global_1.member.member_12.member_13;
let _e12764 = global_1.member.member.member;
let _e12766 = (_e12406 / _e709);
local_145 = bitcast<i32>((_e12752 + (_e12755 * _e12758)));
local_146 = _e299;
local_147 = bitcast<i32>(_e12764);
let _e12769 = global_1.member.member_13.member_6;
let _e12770 = f32(_e12769);
let _e12772 = select(0f, _e12766, (_e12766 > 0f));
let _e12775 = (select(1f, _e12772, (_e12772 < 1f)) * _e12770);
let _e12776 = (_e12770 - 1f);
let _e12778 = select(0f, _e12776, (_e12776 > 0f));
let _e12780 = select(0f, _e12775, (_e12775 > 0f));
let _e12782 = select(_e12778, _e12780, (_e12780 < _e12778));
let _e12789 = select(0i, select(select(i32(_e12782), i32(-2147483648), (_e12782 < -2147483600f)), 2147483647i, (_e12782 > 2147483500f)), (_e12782 == _e12782));
let _e12793 = (_e12789 - select(0i, 1i, (_e12782 < f32(_e12789))));
if (_e12793 > 0i) {
let _e12796 = local_145;
let _e12797 = local_147;
let _e12800 = local_146;
let _e12801 = ((_e12796 + ((_e12793 - 1i) * _e12797)) + _e12800);
let _e12803 = (bitcast<i32>(_e286) - 1i);
let _e12805 = select(_e12803, _e12801, (_e12801 < _e12803));
let _e12810 = global_7.member[bitcast<u32>(select(0i, _e12805, (_e12805 > 0i)))];
phi_29236_ = _e12810;
} else {
phi_29236_ = 0f;
}
let _e12812 = phi_29236_;
let _e12813 = local_145;
let _e12814 = local_147;
let _e12817 = local_146;
let _e12818 = ((_e12813 + (_e12793 * _e12814)) + _e12817);
let _e12820 = (bitcast<i32>(_e286) - 1i);
let _e12822 = select(_e12820, _e12818, (_e12818 < _e12820));
let _e12827 = global_7.member[bitcast<u32>(select(0i, _e12822, (_e12822 > 0i)))];
let _e12834 = (_e12289 - _e12278);
let _e12837 = ((_e12403 - _e12278) / select(1e-9f, _e12834, (_e12834 > 1e-9f)));
local_142 = 0i;
local_143 = _e12290;
local_144 = _e12264;
let _e12839 = select(0f, _e12837, (_e12837 > 0f));
let _e12842 = (select(1f, _e12839, (_e12839 < 1f)) * _e12770);
let _e12844 = select(0f, _e12842, (_e12842 > 0f));
let _e12846 = select(_e12778, _e12844, (_e12844 < _e12778));
let _e12853 = select(0i, select(select(i32(_e12846), i32(-2147483648), (_e12846 < -2147483600f)), 2147483647i, (_e12846 > 2147483500f)), (_e12846 == _e12846));
let _e12857 = (_e12853 - select(0i, 1i, (_e12846 < f32(_e12853))));
if (_e12857 > 0i) {
let _e12860 = local_142;
let _e12861 = local_144;
let _e12864 = local_143;
let _e12865 = ((_e12860 + ((_e12857 - 1i) * _e12861)) + _e12864);
let _e12867 = select(_e12820, _e12865, (_e12865 < _e12820));
let _e12872 = global_7.member[bitcast<u32>(select(0i, _e12867, (_e12867 > 0i)))];
phi_29363_ = _e12872;
} else {
phi_29363_ = 0f;
}
let _e12874 = phi_29363_;
let _e12875 = local_142;
let _e12876 = local_144;
let _e12879 = local_143;
let _e12880 = ((_e12875 + (_e12857 * _e12876)) + _e12879);
let _e12882 = select(_e12820, _e12880, (_e12880 < _e12820));
let _e12887 = global_7.member[bitcast<u32>(select(0i, _e12882, (_e12882 > 0i)))];
let _e12893 = ((_e12812 + ((_e12827 - _e12812) * (_e12775 - f32(_e12793)))) + (_e12874 + ((_e12887 - _e12874) * (_e12842 - f32(_e12857)))));
let _e12896 = global_1.member.member_13.member;
let _e12901 = -((_e12896.member * _e12893));
let _e12903 = select(-87f, _e12901, (_e12901 > -87f));
let _e12905 = select(88f, _e12903, (_e12903 < 88f));
let _e12907 = ((_e12905 * 1.442695f) + 0.5f);
let _e12909 = select(-127f, _e12907, (_e12907 > -127f));
let _e12911 = select(128f, _e12909, (_e12909 < 128f));
let _e12918 = select(0i, select(select(i32(_e12911), i32(-2147483648), (_e12911 < -2147483600f)), 2147483647i, (_e12911 > 2147483500f)), (_e12911 == _e12911));
let _e12922 = (_e12918 - select(0i, 1i, (_e12911 < f32(_e12918))));
let _e12923 = f32(_e12922);
let _e12927 = ((_e12905 - (_e12923 * 0.6933594f)) - (_e12923 * -2.1219444e-4f));
let _e12949 = -((_e12896.member_1 * _e12893));
let _e12951 = select(-87f, _e12949, (_e12949 > -87f));
let _e12953 = select(88f, _e12951, (_e12951 < 88f));
let _e12955 = ((_e12953 * 1.442695f) + 0.5f);
let _e12957 = select(-127f, _e12955, (_e12955 > -127f));
let _e12959 = select(128f, _e12957, (_e12957 < 128f));
let _e12966 = select(0i, select(select(i32(_e12959), i32(-2147483648), (_e12959 < -2147483600f)), 2147483647i, (_e12959 > 2147483500f)), (_e12959 == _e12959));
let _e12970 = (_e12966 - select(0i, 1i, (_e12959 < f32(_e12966))));
let _e12971 = f32(_e12970);
let _e12975 = ((_e12953 - (_e12971 * 0.6933594f)) - (_e12971 * -2.1219444e-4f));
let _e12997 = -((_e12896.member_2 * _e12893));
let _e12999 = select(-87f, _e12997, (_e12997 > -87f));
let _e13001 = select(88f, _e12999, (_e12999 < 88f));
let _e13003 = ((_e13001 * 1.442695f) + 0.5f);
let _e13005 = select(-127f, _e13003, (_e13003 > -127f));
let _e13007 = select(128f, _e13005, (_e13005 < 128f));
let _e13014 = select(0i, select(select(i32(_e13007), i32(-2147483648), (_e13007 < -2147483600f)), 2147483647i, (_e13007 > 2147483500f)), (_e13007 == _e13007));
let _e13018 = (_e13014 - select(0i, 1i, (_e13007 < f32(_e13014))));
let _e13019 = f32(_e13018);
let _e13023 = ((_e13001 - (_e13019 * 0.6933594f)) - (_e13019 * -2.1219444e-4f));
let _e13046 = global_1.member.member_13.member_1;
let _e13059 = select(0f, _e12403, (((_e12406 >= 0f) && (_e12406 < _e709)) && (_e12403 > 0f)));
let _e13062 = ((_e13059 > 0f) && (_e13059 < _e12221));
if _e471 {
phi_29648_ = type_26(_e12121, _e12025);
} else {
phi_29648_ = type_26(_e12025, _e12121);
}
let _e13086 = phi_29648_;
let _e13089 = (_e12122 && _e13062);
let _e13092 = global_1.member.member_18.member;
let _e13093 = (((select(_e12147, (1f - _e12147), (_e12132 >= 0f)) - select(_e12166, (1f - _e12166), (_e12151 >= 0f))) * (1f / _e12129)) * _e13092);
let _e13097 = select(0f, ((((_e670 * _e13046.member) * ((1f + (_e12927 * (1f + (_e12927 * (0.5f + (_e12927 * (0.16666667f + (_e12927 * (0.041666668f + (_e12927 * (0.008333334f + (_e12927 * (0.001388889f + (_e12927 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12922 + 127i)) << bitcast<u32>(23i))))) * _e12749) * _e13093), _e13089);
let _e13098 = select(0f, ((((_e683 * _e13046.member_1) * ((1f + (_e12975 * (1f + (_e12975 * (0.5f + (_e12975 * (0.16666667f + (_e12975 * (0.041666668f + (_e12975 * (0.008333334f + (_e12975 * (0.001388889f + (_e12975 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12970 + 127i)) << bitcast<u32>(23i))))) * _e12749) * _e13093), _e13089);
let _e13099 = select(0f, ((((_e696 * _e13046.member_2) * ((1f + (_e13023 * (1f + (_e13023 * (0.5f + (_e13023 * (0.16666667f + (_e13023 * (0.041666668f + (_e13023 * (0.008333334f + (_e13023 * (0.001388889f + (_e13023 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e13018 + 127i)) << bitcast<u32>(23i))))) * _e12749) * _e13093), _e13089);
let _e13103 = (bitcast<f32>((bitcast<u32>(_e13097) & 2147483647u)) >= 1073741800f);
let _e13104 = (1f / 1048576f);
let _e13107 = ((_e13097 * select(1f, _e13104, _e13103)) + 0.5f);
let _e13109 = select(-1073741800f, _e13107, (_e13107 > -1073741800f));
let _e13111 = select(1073741800f, _e13109, (_e13109 < 1073741800f));
let _e13118 = select(0i, select(select(i32(_e13111), i32(-2147483648), (_e13111 < -2147483600f)), 2147483647i, (_e13111 > 2147483500f)), (_e13111 == _e13111));
let _e13122 = (_e13118 - select(0i, 1i, (_e13111 < f32(_e13118))));
let _e13123 = select(0i, 20i, _e13103);
let _e13127 = (bitcast<u32>(_e13122) << bitcast<u32>((_e13123 & 31i)));
let _e13134 = bitcast<u32>(((_e13122 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e13123) & 31i))));
let _e13138 = (bitcast<f32>((bitcast<u32>(_e13098) & 2147483647u)) >= 1073741800f);
let _e13141 = ((_e13098 * select(1f, _e13104, _e13138)) + 0.5f);
let _e13143 = select(-1073741800f, _e13141, (_e13141 > -1073741800f));
let _e13145 = select(1073741800f, _e13143, (_e13143 < 1073741800f));
let _e13152 = select(0i, select(select(i32(_e13145), i32(-2147483648), (_e13145 < -2147483600f)), 2147483647i, (_e13145 > 2147483500f)), (_e13145 == _e13145));
let _e13156 = (_e13152 - select(0i, 1i, (_e13145 < f32(_e13152))));
let _e13157 = select(0i, 20i, _e13138);
let _e13161 = (bitcast<u32>(_e13156) << bitcast<u32>((_e13157 & 31i)));
let _e13168 = bitcast<u32>(((_e13156 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e13157) & 31i))));
let _e13172 = (bitcast<f32>((bitcast<u32>(_e13099) & 2147483647u)) >= 1073741800f);
let _e13175 = ((_e13099 * select(1f, _e13104, _e13172)) + 0.5f);
let _e13177 = select(-1073741800f, _e13175, (_e13175 > -1073741800f));
let _e13179 = select(1073741800f, _e13177, (_e13177 < 1073741800f));
let _e13186 = select(0i, select(select(i32(_e13179), i32(-2147483648), (_e13179 < -2147483600f)), 2147483647i, (_e13179 > 2147483500f)), (_e13179 == _e13179));
let _e13190 = (_e13186 - select(0i, 1i, (_e13179 < f32(_e13186))));
let _e13191 = select(0i, 20i, _e13172);
let _e13195 = (bitcast<u32>(_e13190) << bitcast<u32>((_e13191 & 31i)));
let _e13202 = bitcast<u32>(((_e13190 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e13191) & 31i))));
let _e13207 = global_1.member.member_18.member_2;
let _e13210 = global_1.member.member_18.member_3;
let _e13213 = global_1.member.member_18.member_4;
let _e13216 = global_1.member.member_18.member_5;
if _e11982 {
phi_29847_ = 0u;
} else {
if (_e784 == 1u) {
phi_29846_ = _e13207;
} else {
if (_e784 == 2u) {
phi_29845_ = _e13210;
} else {
phi_29845_ = select(_e13216, _e13213, (_e784 == 3u));
}
let _e13222 = phi_29845_;
phi_29846_ = _e13222;
}
let _e13224 = phi_29846_;
phi_29847_ = _e13224;
}
let _e13226 = phi_29847_;
let _e13234 = bitcast<i32>(bitcast<u32>((((bitcast<i32>(_e13226) + (_e13086.member_1 * _e11994)) + _e13086.member) * 6i)));
if ((_e13127 | _e13134) == 0u) {
} else {
let _e13237 = bitcast<u32>(_e13234);
if (_e13237 < _e288) {
let _e13241 = atomicAdd((&global_8.member[_e13237]), _e13127);
phi_29881_ = _e13241;
} else {
phi_29881_ = 0u;
}
let _e13243 = phi_29881_;
let _e13247 = (_e13134 + select(0u, 1u, ((_e13243 + _e13127) < _e13127)));
if (_e13247 == 0u) {
} else {
let _e13249 = (_e13237 + 1u);
if (_e13249 < _e288) {
let _e13253 = atomicAdd((&global_8.member[_e13249]), _e13247);
}
}
}
if ((_e13161 | _e13168) == 0u) {
} else {
let _e13257 = bitcast<u32>((_e13234 + 2i));
if (_e13257 < _e288) {
let _e13261 = atomicAdd((&global_8.member[_e13257]), _e13161);
phi_29911_ = _e13261;
} else {
phi_29911_ = 0u;
}
let _e13263 = phi_29911_;
let _e13267 = (_e13168 + select(0u, 1u, ((_e13263 + _e13161) < _e13161)));
if (_e13267 == 0u) {
} else {
let _e13269 = (_e13257 + 1u);
if (_e13269 < _e288) {
let _e13273 = atomicAdd((&global_8.member[_e13269]), _e13267);
}
}
}
if ((_e13195 | _e13202) == 0u) {
} else {
let _e13277 = bitcast<u32>((_e13234 + 4i));
if (_e13277 < _e288) {
let _e13281 = atomicAdd((&global_8.member[_e13277]), _e13195);
phi_29941_ = _e13281;
} else {
phi_29941_ = 0u;
}
let _e13283 = phi_29941_;
let _e13287 = (_e13202 + select(0u, 1u, ((_e13283 + _e13195) < _e13195)));
if (_e13287 == 0u) {
} else {
let _e13289 = (_e13277 + 1u);
if (_e13289 < _e288) {
let _e13293 = atomicAdd((&global_8.member[_e13289]), _e13287);
}
}
}
let _e13294 = bitcast<i32>(bitcast<u32>(select(-1i, _e12121, (_e12122 && (!(((_e13062 && !(((((_e12025 * _e12017) == _e316) && (_e863 != _e784)) || ((((_e12025 + 1i) * _e12017) == _e710) && (_e941 != _e784))))) && ((_e13059 * (1f + (0.02f * _e12018))) < _e12242))) && (_e13059 <= _e12231))))));
if (_e13294 >= 0i) {
phi_29978_ = type_26(select(_e12116.member, _e13294, (_e13294 < _e12116.member)), select(_e12116.member_1, _e13294, (_e13294 > _e12116.member_1)));
} else {
phi_29978_ = _e12116;
}
let _e13304 = phi_29978_;
phi_28030_ = _e13304;
phi_28033_ = (_e12118 + 1i);
} else {
phi_28030_ = type_26();
phi_28033_ = i32();
}
let _e13307 = phi_28030_;
let _e13309 = phi_28033_;
continue;
continuing {
phi_28029_ = _e13307;
phi_28032_ = _e13309;
break if !(_e12122);
}
}
let _e27486 = local_255;
phi_27876_ = _e27486;
phi_27879_ = (_e12014 + 1i);
} else {
phi_27876_ = type_26();
phi_27879_ = i32();
}
let _e13313 = phi_27876_;
let _e13315 = phi_27879_;
continue;
continuing {
phi_27875_ = _e13313;
phi_27878_ = _e13315;
break if !(_e12015);
}
}
let _e13318 = local_243;
let _e13321 = local_244;
if (_e13318.member <= _e13321.member_1) {
let _e13326 = ((_e13321.member_1 + 1i) << bitcast<u32>(_e11983));
if (_e13326 <= _e11981) {
phi_29995_ = (_e13326 - 1i);
} else {
phi_29995_ = _e11981;
}
let _e13330 = phi_29995_;
let _e13332 = (_e13318.member << bitcast<u32>(_e11983));
let _e13334 = select(_e863, 0u, (_e863 == _e784));
let _e13338 = select(_e941, 0u, ((_e941 == _e784) || (_e941 == _e863)));
let _e13346 = ((select(0u, 1u, (_e784 > 0u)) + select(0u, 1u, (_e13334 > 0u))) + select(0u, 1u, (_e13338 > 0u)));
if (_e13346 == 0u) {
phi_30030_ = 0i;
loop {
let _e18380 = phi_30030_;
let _e18381 = (_e18380 < 16i);
if _e18381 {
let _e18383 = (_e11976 + (_e18380 & 15i));
let _e18387 = (((f32(_e18383) + 0.5f) * 1f) - 0.5f);
let _e18391 = (-(((_e434 * _e18387) + _e460)) / _e447);
let _e18398 = bitcast<f32>((bitcast<u32>(((_e484 * _e18387) + ((_e497 * _e18391) + _e510))) & 2147483647u));
let _e18405 = bitcast<f32>((bitcast<u32>(((_e523 * _e18387) + ((_e536 * _e18391) + _e549))) & 2147483647u));
let _e18409 = (((0.5f * (_e18398 + _e18405)) / _e552) + _e735);
let _e18410 = (1f / 1f);
let _e18418 = ((((_e18391 + _e18409) + 0.5f) * _e18410) - 0.5f);
let _e18419 = f32(_e13332);
let _e18420 = f32(_e13330);
let _e18421 = (_e18419 - 1f);
let _e18423 = select(_e18421, _e18418, (_e18418 > _e18421));
let _e18425 = select(_e18420, _e18423, (_e18423 < _e18420));
let _e18432 = select(0i, select(select(i32(_e18425), i32(-2147483648), (_e18425 < -2147483600f)), 2147483647i, (_e18425 > 2147483500f)), (_e18425 == _e18425));
let _e18437 = (((((_e18391 - _e18409) + 0.5f) * _e18410) - 0.5f) + 1f);
let _e18438 = (_e18420 + 1f);
let _e18440 = select(_e18419, _e18437, (_e18437 > _e18419));
let _e18442 = select(_e18438, _e18440, (_e18440 < _e18438));
let _e18449 = select(0i, select(select(i32(_e18442), i32(-2147483648), (_e18442 < -2147483600f)), 2147483647i, (_e18442 > 2147483500f)), (_e18442 == _e18442));
let _e18460 = ((1e-4f * 1f) * _e552);
let _e18462 = select(_e18405, _e18398, (_e18398 > _e18405));
let _e18464 = select(_e18460, _e18462, (_e18462 > _e18460));
let _e18466 = select(_e18405, _e18398, (_e18398 < _e18405));
let _e18468 = select(_e18460, _e18466, (_e18466 > _e18460));
let _e18470 = (0.5f * (_e18464 + _e18468));
let _e18471 = (0.5f / _e18468);
let _e18472 = (1f / _e18464);
phi_30184_ = 0i;
loop {
let _e18474 = phi_30184_;
let _e18476 = (((_e18449 - select(0i, 1i, (_e18442 < f32(_e18449)))) + (_e18380 >> bitcast<u32>(4u))) + bitcast<i32>(_e18474));
let _e18477 = (_e18476 <= select(-1i, (_e18432 - select(0i, 1i, (_e18425 < f32(_e18432)))), (_e18383 <= _e11980)));
if _e18477 {
let _e18483 = (((((f32(_e18476) + 0.5f) * 1f) - 0.5f) - _e18391) * _e552);
let _e18484 = (_e552 * 1f);
let _e18486 = (0.5f * _e18484);
let _e18487 = (_e18483 + _e18486);
let _e18488 = -(_e18487);
let _e18491 = (_e18470 - select(_e18488, _e18487, (_e18487 > _e18488)));
let _e18493 = select(0f, _e18491, (_e18491 > 0f));
let _e18495 = select(_e18468, _e18493, (_e18493 < _e18468));
let _e18498 = (_e18491 - _e18468);
let _e18502 = (((_e18495 * (_e18495 * _e18471)) + select(0f, _e18498, (_e18498 > 0f))) * _e18472);
let _e18506 = (_e18483 - _e18486);
let _e18507 = -(_e18506);
let _e18510 = (_e18470 - select(_e18507, _e18506, (_e18506 > _e18507)));
let _e18512 = select(0f, _e18510, (_e18510 > 0f));
let _e18514 = select(_e18468, _e18512, (_e18512 < _e18468));
let _e18517 = (_e18510 - _e18468);
let _e18521 = (((_e18514 * (_e18514 * _e18471)) + select(0f, _e18517, (_e18517 > 0f))) * _e18472);
if _e471 {
phi_30289_ = type_26(_e18476, _e18383);
} else {
phi_30289_ = type_26(_e18383, _e18476);
}
let _e18530 = phi_30289_;
let _e18534 = bitcast<i32>((_e11927 * _e11930));
local_140 = _e18534;
local_141 = ((_e18530.member_1 * _e11931) + _e18530.member);
let _e18537 = local_140;
let _e18538 = local_141;
let _e18539 = (_e18537 + _e18538);
let _e18541 = (bitcast<i32>(_e277) - 1i);
let _e18543 = select(_e18541, _e18539, (_e18539 < _e18541));
let _e18548 = global_5.member[bitcast<u32>(select(0i, _e18543, (_e18543 > 0i)))];
let _e18549 = local_140;
let _e18551 = local_141;
let _e18552 = ((2i * _e18549) + _e18551);
let _e18554 = select(_e18541, _e18552, (_e18552 < _e18541));
let _e18559 = global_5.member[bitcast<u32>(select(0i, _e18554, (_e18554 > 0i)))];
let _e18560 = local_141;
let _e18562 = select(_e18541, _e18560, (_e18560 < _e18541));
let _e18567 = global_5.member[bitcast<u32>(select(0i, _e18562, (_e18562 > 0i)))];
let _e18568 = local_141;
let _e18579 = global_1.member.member_2.member;
let _e18580 = (((((f32(_e18530.member) + 0.5f) / f32(_e11931)) * 2f) - 1f) * _e18579);
let _e18587 = global_1.member.member_2.member_1;
let _e18588 = ((1f - (((f32(_e18530.member_1) + 0.5f) / f32(_e11932)) * 2f)) * _e18587);
let _e18590 = global_1.member.member_3;
let _e18598 = global_1.member.member_4;
let _e18605 = ((_e18590.member * _e18580) + (_e18598.member * _e18588));
let _e18606 = ((_e18590.member_1 * _e18580) + (_e18598.member_1 * _e18588));
let _e18607 = ((_e18590.member_2 * _e18580) + (_e18598.member_2 * _e18588));
let _e18610 = global_1.member.member_2.member_3;
let _e18611 = (_e18610 != 0u);
let _e18613 = global_1.member.member_5;
let _e18620 = select((_e18613.member + _e18605), _e18613.member, _e18611);
let _e18621 = select((_e18613.member_1 + _e18606), _e18613.member_1, _e18611);
let _e18622 = select((_e18613.member_2 + _e18607), _e18613.member_2, _e18611);
let _e18624 = global_1.member.member_6;
let _e18631 = select(_e18624.member, (_e18624.member + _e18605), _e18611);
let _e18632 = select(_e18624.member_1, (_e18624.member_1 + _e18606), _e18611);
let _e18633 = select(_e18624.member_2, (_e18624.member_2 + _e18607), _e18611);
let _e18638 = (((_e18620 * _e18620) + (_e18621 * _e18621)) + (_e18622 * _e18622));
let _e18641 = sqrt(select(0f, _e18638, (_e18638 > 0f)));
let _e18642 = (1f / _e18641);
let _e18643 = (_e18620 * _e18642);
let _e18644 = (_e18621 * _e18642);
let _e18645 = (_e18622 * _e18642);
let _e18646 = (_e593 - _e18631);
let _e18647 = (_e605 - _e18632);
let _e18648 = (_e618 - _e18633);
let _e18653 = (((_e18646 * _e18643) + (_e18647 * _e18644)) + (_e18648 * _e18645));
let _e18658 = (((_e18646 * _e631) + (_e18647 * _e644)) + (_e18648 * _e657));
let _e18663 = (((_e18643 * _e631) + (_e18644 * _e644)) + (_e18645 * _e657));
let _e18666 = ((_e18644 * _e657) - (_e18645 * _e644));
let _e18669 = ((_e18645 * _e631) - (_e18643 * _e657));
let _e18672 = ((_e18643 * _e644) - (_e18644 * _e631));
let _e18677 = (((_e18666 * _e18666) + (_e18669 * _e18669)) + (_e18672 * _e18672));
let _e18680 = (1f / select(1e-9f, _e18677, (_e18677 > 1e-9f)));
let _e18683 = ((_e18653 - (_e18663 * _e18658)) * _e18680);
let _e18686 = (((_e18663 * _e18653) - _e18658) * _e18680);
let _e18692 = -(_e18663);
let _e18695 = global_1.member.member_13.member_2;
let _e18696 = (_e18695 * _e18695);
let _e18700 = ((1f + _e18696) - ((2f * _e18695) * _e18692));
let _e18702 = select(1e-9f, _e18700, (_e18700 > 1e-9f));
let _e18714 = global_1.member.member_13.member_3;
if (_e18714 == 2u) {
let _e18719 = (0.5f - (0.5f * _e18692));
let _e18721 = select(0f, _e18719, (_e18719 > 0f));
let _e18725 = (sqrt(select(0f, _e18721, (_e18721 > 0f))) * 255f);
let _e18726 = (255f - 1f);
let _e18728 = select(0f, _e18725, (_e18725 > 0f));
let _e18730 = select(_e18726, _e18728, (_e18728 < _e18726));
let _e18737 = select(0i, select(select(i32(_e18730), i32(-2147483648), (_e18730 < -2147483600f)), 2147483647i, (_e18730 > 2147483500f)), (_e18730 == _e18730));
let _e18741 = (_e18737 - select(0i, 1i, (_e18730 < f32(_e18737))));
let _e18744 = global_1.member.member_13.member_11;
let _e18745 = bitcast<i32>(_e18744);
let _e18746 = (_e18745 + _e18741);
let _e18748 = (bitcast<i32>(_e283) - 1i);
let _e18750 = select(_e18748, _e18746, (_e18746 < _e18748));
let _e18755 = global_2.member[bitcast<u32>(select(0i, _e18750, (_e18750 > 0i)))];
let _e18757 = (_e18745 + (_e18741 + 1i));
let _e18759 = select(_e18748, _e18757, (_e18757 < _e18748));
let _e18764 = global_2.member[bitcast<u32>(select(0i, _e18759, (_e18759 > 0i)))];
phi_30716_ = (_e18755 + ((_e18764 - _e18755) * (_e18725 - f32(_e18741))));
} else {
phi_30716_ = select(((1f - _e18696) / (_e18702 * sqrt(select(0f, _e18702, (_e18702 > 0f))))), (0.75f * (1f + (_e18692 * _e18692))), (_e18714 == 1u));
}
let _e18771 = phi_30716_;
let _e18783 = global_1.member.member_13.member_7;
let _e18784 = bitcast<i32>(_e18783);
let _e18787 = global_1.member.member_13.member_8;
let _e18788 = bitcast<i32>(_e18787);
let _e18791 = global_1.member.member_13.member_9;
let _e18792 = bitcast<i32>(_e18791);
let _e18795 = global_1.member.member_13.member_4;
let _e18801 = global_1.member.member_13.member_5;
let _e18805 = f32(_e18784);
let _e18810 = (((((_e18631 + (_e18643 * _e18683)) - _e18795.member) / (_e18801.member - _e18795.member)) * _e18805) - 0.5f);
let _e18811 = (_e18805 - 1f);
let _e18813 = select(0f, _e18810, (_e18810 > 0f));
let _e18815 = select(_e18811, _e18813, (_e18813 < _e18811));
let _e18816 = f32(_e18788);
let _e18821 = (((((_e18632 + (_e18644 * _e18683)) - _e18795.member_1) / (_e18801.member_1 - _e18795.member_1)) * _e18816) - 0.5f);
let _e18822 = (_e18816 - 1f);
let _e18824 = select(0f, _e18821, (_e18821 > 0f));
let _e18826 = select(_e18822, _e18824, (_e18824 < _e18822));
let _e18827 = f32(_e18792);
let _e18832 = (((((_e18633 + (_e18645 * _e18683)) - _e18795.member_2) / (_e18801.member_2 - _e18795.member_2)) * _e18827) - 0.5f);
let _e18833 = (_e18827 - 1f);
let _e18835 = select(0f, _e18832, (_e18832 > 0f));
let _e18837 = select(_e18833, _e18835, (_e18835 < _e18833));
let _e18839 = select(0f, _e18815, (_e18815 > 0f));
let _e18841 = select(1e6f, _e18839, (_e18839 < 1e6f));
let _e18848 = select(0i, select(select(i32(_e18841), i32(-2147483648), (_e18841 < -2147483600f)), 2147483647i, (_e18841 > 2147483500f)), (_e18841 == _e18841));
let _e18852 = (_e18848 - select(0i, 1i, (_e18841 < f32(_e18848))));
let _e18854 = select(0f, _e18826, (_e18826 > 0f));
let _e18856 = select(1e6f, _e18854, (_e18854 < 1e6f));
let _e18863 = select(0i, select(select(i32(_e18856), i32(-2147483648), (_e18856 < -2147483600f)), 2147483647i, (_e18856 > 2147483500f)), (_e18856 == _e18856));
let _e18867 = (_e18863 - select(0i, 1i, (_e18856 < f32(_e18863))));
let _e18869 = select(0f, _e18837, (_e18837 > 0f));
let _e18871 = select(1e6f, _e18869, (_e18869 < 1e6f));
let _e18878 = select(0i, select(select(i32(_e18871), i32(-2147483648), (_e18871 < -2147483600f)), 2147483647i, (_e18871 > 2147483500f)), (_e18871 == _e18871));
let _e18882 = (_e18878 - select(0i, 1i, (_e18871 < f32(_e18878))));
let _e18886 = (_e18826 - f32(_e18867));
let _e18888 = (_e18837 - f32(_e18882));
local_138 = (_e18815 - f32(_e18852));
let _e18889 = (_e18852 + 1i);
let _e18891 = select(_e18889, 0i, (_e18889 < 0i));
if (_e18891 >= _e18784) {
phi_30848_ = (_e18784 - 1i);
} else {
phi_30848_ = _e18891;
}
let _e18895 = phi_30848_;
local_139 = (_e18895 - _e18852);
let _e18897 = (_e18867 + 1i);
let _e18899 = select(_e18897, 0i, (_e18897 < 0i));
if (_e18899 >= _e18788) {
phi_30861_ = (_e18788 - 1i);
} else {
phi_30861_ = _e18899;
}
let _e18903 = phi_30861_;
let _e18905 = ((_e18903 - _e18867) * _e18784);
let _e18906 = (_e18882 + 1i);
let _e18908 = select(_e18906, 0i, (_e18906 < 0i));
if (_e18908 >= _e18792) {
phi_30875_ = (_e18792 - 1i);
} else {
phi_30875_ = _e18908;
}
let _e18912 = phi_30875_;
let _e18918 = global_1.member.member_13.member_10;
let _e18924 = ((bitcast<i32>(_e18918) + (((_e18882 * _e18788) + _e18867) * _e18784)) + _e18852);
let _e18926 = (bitcast<i32>(_e283) - 1i);
let _e18928 = select(_e18926, _e18924, (_e18924 < _e18926));
let _e18933 = global_2.member[bitcast<u32>(select(0i, _e18928, (_e18928 > 0i)))];
let _e18934 = local_138;
let _e18937 = local_139;
let _e18938 = (_e18924 + _e18937);
let _e18940 = select(_e18926, _e18938, (_e18938 < _e18926));
let _e18945 = global_2.member[bitcast<u32>(select(0i, _e18940, (_e18940 > 0i)))];
let _e18946 = local_138;
let _e18949 = (1f - _e18886);
let _e18951 = (_e18924 + _e18905);
let _e18953 = select(_e18926, _e18951, (_e18951 < _e18926));
let _e18958 = global_2.member[bitcast<u32>(select(0i, _e18953, (_e18953 > 0i)))];
let _e18959 = local_138;
let _e18962 = local_139;
let _e18963 = (_e18951 + _e18962);
let _e18965 = select(_e18926, _e18963, (_e18963 < _e18926));
let _e18970 = global_2.member[bitcast<u32>(select(0i, _e18965, (_e18965 > 0i)))];
let _e18971 = local_138;
let _e18976 = (_e18924 + (((_e18912 - _e18882) * _e18784) * _e18788));
let _e18978 = select(_e18926, _e18976, (_e18976 < _e18926));
let _e18983 = global_2.member[bitcast<u32>(select(0i, _e18978, (_e18978 > 0i)))];
let _e18984 = local_138;
let _e18987 = local_139;
let _e18988 = (_e18976 + _e18987);
let _e18990 = select(_e18926, _e18988, (_e18988 < _e18926));
let _e18995 = global_2.member[bitcast<u32>(select(0i, _e18990, (_e18990 > 0i)))];
let _e18996 = local_138;
let _e19000 = (_e18976 + _e18905);
let _e19002 = select(_e18926, _e19000, (_e19000 < _e18926));
let _e19007 = global_2.member[bitcast<u32>(select(0i, _e19002, (_e19002 > 0i)))];
let _e19008 = local_138;
let _e19011 = local_139;
let _e19012 = (_e19000 + _e19011);
let _e19014 = select(_e18926, _e19012, (_e19012 < _e18926));
let _e19019 = global_2.member[bitcast<u32>(select(0i, _e19014, (_e19014 > 0i)))];
let _e19020 = local_138;
let _e19029 = ((_e18641 * (_e18771 * (0.25f / 3.1415927f))) * ((((((_e18933 * (1f - _e18934)) + (_e18945 * _e18946)) * _e18949) + (((_e18958 * (1f - _e18959)) + (_e18970 * _e18971)) * _e18886)) * (1f - _e18888)) + (((((_e18983 * (1f - _e18984)) + (_e18995 * _e18996)) * _e18949) + (((_e19007 * (1f - _e19008)) + (_e19019 * _e19020)) * _e18886)) * _e18888)));
let _e19032 = global_1.member.member_12.member_12;
let _e19035 = global_1.member.member_12.member_4;
let _e19038 = global_1.member.member_12.member_13;
let _e19044 = global_1.member.member.member;
let _e19046 = (_e18686 / _e709);
local_135 = bitcast<i32>((_e19032 + (_e19035 * _e19038)));
local_136 = _e299;
local_137 = bitcast<i32>(_e19044);
let _e19049 = global_1.member.member_13.member_6;
let _e19050 = f32(_e19049);
let _e19052 = select(0f, _e19046, (_e19046 > 0f));
let _e19055 = (select(1f, _e19052, (_e19052 < 1f)) * _e19050);
let _e19056 = (_e19050 - 1f);
let _e19058 = select(0f, _e19056, (_e19056 > 0f));
let _e19060 = select(0f, _e19055, (_e19055 > 0f));
let _e19062 = select(_e19058, _e19060, (_e19060 < _e19058));
let _e19069 = select(0i, select(select(i32(_e19062), i32(-2147483648), (_e19062 < -2147483600f)), 2147483647i, (_e19062 > 2147483500f)), (_e19062 == _e19062));
let _e19073 = (_e19069 - select(0i, 1i, (_e19062 < f32(_e19069))));
if (_e19073 > 0i) {
let _e19076 = local_135;
let _e19077 = local_137;
let _e19080 = local_136;
let _e19081 = ((_e19076 + ((_e19073 - 1i) * _e19077)) + _e19080);
let _e19083 = (bitcast<i32>(_e286) - 1i);
let _e19085 = select(_e19083, _e19081, (_e19081 < _e19083));
let _e19090 = global_7.member[bitcast<u32>(select(0i, _e19085, (_e19085 > 0i)))];
phi_31179_ = _e19090;
} else {
phi_31179_ = 0f;
}
let _e19092 = phi_31179_;
let _e19093 = local_135;
let _e19094 = local_137;
let _e19097 = local_136;
let _e19098 = ((_e19093 + (_e19073 * _e19094)) + _e19097);
let _e19100 = (bitcast<i32>(_e286) - 1i);
let _e19102 = select(_e19100, _e19098, (_e19098 < _e19100));
let _e19107 = global_7.member[bitcast<u32>(select(0i, _e19102, (_e19102 > 0i)))];
let _e19114 = (_e18559 - _e18548);
let _e19117 = ((_e18683 - _e18548) / select(1e-9f, _e19114, (_e19114 > 1e-9f)));
local_132 = 0i;
local_133 = _e18568;
local_134 = _e18534;
let _e19119 = select(0f, _e19117, (_e19117 > 0f));
let _e19122 = (select(1f, _e19119, (_e19119 < 1f)) * _e19050);
let _e19124 = select(0f, _e19122, (_e19122 > 0f));
let _e19126 = select(_e19058, _e19124, (_e19124 < _e19058));
let _e19133 = select(0i, select(select(i32(_e19126), i32(-2147483648), (_e19126 < -2147483600f)), 2147483647i, (_e19126 > 2147483500f)), (_e19126 == _e19126));
let _e19137 = (_e19133 - select(0i, 1i, (_e19126 < f32(_e19133))));
if (_e19137 > 0i) {
let _e19140 = local_132;
let _e19141 = local_134;
let _e19144 = local_133;
let _e19145 = ((_e19140 + ((_e19137 - 1i) * _e19141)) + _e19144);
let _e19147 = select(_e19100, _e19145, (_e19145 < _e19100));
let _e19152 = global_7.member[bitcast<u32>(select(0i, _e19147, (_e19147 > 0i)))];
phi_31306_ = _e19152;
} else {
phi_31306_ = 0f;
}
let _e19154 = phi_31306_;
let _e19155 = local_132;
let _e19156 = local_134;
let _e19159 = local_133;
let _e19160 = ((_e19155 + (_e19137 * _e19156)) + _e19159);
let _e19162 = select(_e19100, _e19160, (_e19160 < _e19100));
let _e19167 = global_7.member[bitcast<u32>(select(0i, _e19162, (_e19162 > 0i)))];
let _e19173 = ((_e19092 + ((_e19107 - _e19092) * (_e19055 - f32(_e19073)))) + (_e19154 + ((_e19167 - _e19154) * (_e19122 - f32(_e19137)))));
let _e19176 = global_1.member.member_13.member;
let _e19181 = -((_e19176.member * _e19173));
let _e19183 = select(-87f, _e19181, (_e19181 > -87f));
let _e19185 = select(88f, _e19183, (_e19183 < 88f));
let _e19187 = ((_e19185 * 1.442695f) + 0.5f);
let _e19189 = select(-127f, _e19187, (_e19187 > -127f));
let _e19191 = select(128f, _e19189, (_e19189 < 128f));
let _e19198 = select(0i, select(select(i32(_e19191), i32(-2147483648), (_e19191 < -2147483600f)), 2147483647i, (_e19191 > 2147483500f)), (_e19191 == _e19191));
let _e19202 = (_e19198 - select(0i, 1i, (_e19191 < f32(_e19198))));
let _e19203 = f32(_e19202);
let _e19207 = ((_e19185 - (_e19203 * 0.6933594f)) - (_e19203 * -2.1219444e-4f));
let _e19229 = -((_e19176.member_1 * _e19173));
let _e19231 = select(-87f, _e19229, (_e19229 > -87f));
let _e19233 = select(88f, _e19231, (_e19231 < 88f));
let _e19235 = ((_e19233 * 1.442695f) + 0.5f);
let _e19237 = select(-127f, _e19235, (_e19235 > -127f));
let _e19239 = select(128f, _e19237, (_e19237 < 128f));
let _e19246 = select(0i, select(select(i32(_e19239), i32(-2147483648), (_e19239 < -2147483600f)), 2147483647i, (_e19239 > 2147483500f)), (_e19239 == _e19239));
let _e19250 = (_e19246 - select(0i, 1i, (_e19239 < f32(_e19246))));
let _e19251 = f32(_e19250);
let _e19255 = ((_e19233 - (_e19251 * 0.6933594f)) - (_e19251 * -2.1219444e-4f));
let _e19277 = -((_e19176.member_2 * _e19173));
let _e19279 = select(-87f, _e19277, (_e19277 > -87f));
let _e19281 = select(88f, _e19279, (_e19279 < 88f));
let _e19283 = ((_e19281 * 1.442695f) + 0.5f);
let _e19285 = select(-127f, _e19283, (_e19283 > -127f));
let _e19287 = select(128f, _e19285, (_e19285 < 128f));
let _e19294 = select(0i, select(select(i32(_e19287), i32(-2147483648), (_e19287 < -2147483600f)), 2147483647i, (_e19287 > 2147483500f)), (_e19287 == _e19287));
let _e19298 = (_e19294 - select(0i, 1i, (_e19287 < f32(_e19294))));
let _e19299 = f32(_e19298);
let _e19303 = ((_e19281 - (_e19299 * 0.6933594f)) - (_e19299 * -2.1219444e-4f));
let _e19326 = global_1.member.member_13.member_1;
let _e19339 = select(0f, _e18683, (((_e18686 >= 0f) && (_e18686 < _e709)) && (_e18683 > 0f)));
if _e471 {
phi_31570_ = type_26(_e18476, _e18383);
} else {
phi_31570_ = type_26(_e18383, _e18476);
}
let _e19350 = phi_31570_;
let _e19353 = (_e18477 && (((_e19339 > 0f) && (_e19339 < _e18567)) && true));
let _e19356 = global_1.member.member_18.member;
let _e19357 = (((select(_e18502, (1f - _e18502), (_e18487 >= 0f)) - select(_e18521, (1f - _e18521), (_e18506 >= 0f))) * (1f / _e18484)) * _e19356);
let _e19361 = select(0f, (((((_e670 * _e19326.member) * ((1f + (_e19207 * (1f + (_e19207 * (0.5f + (_e19207 * (0.16666667f + (_e19207 * (0.041666668f + (_e19207 * (0.008333334f + (_e19207 * (0.001388889f + (_e19207 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e19202 + 127i)) << bitcast<u32>(23i))))) * _e19029) * 1f) * _e19357), _e19353);
let _e19362 = select(0f, (((((_e683 * _e19326.member_1) * ((1f + (_e19255 * (1f + (_e19255 * (0.5f + (_e19255 * (0.16666667f + (_e19255 * (0.041666668f + (_e19255 * (0.008333334f + (_e19255 * (0.001388889f + (_e19255 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e19250 + 127i)) << bitcast<u32>(23i))))) * _e19029) * 1f) * _e19357), _e19353);
let _e19363 = select(0f, (((((_e696 * _e19326.member_2) * ((1f + (_e19303 * (1f + (_e19303 * (0.5f + (_e19303 * (0.16666667f + (_e19303 * (0.041666668f + (_e19303 * (0.008333334f + (_e19303 * (0.001388889f + (_e19303 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e19298 + 127i)) << bitcast<u32>(23i))))) * _e19029) * 1f) * _e19357), _e19353);
let _e19367 = (bitcast<f32>((bitcast<u32>(_e19361) & 2147483647u)) >= 1073741800f);
let _e19368 = (1f / 1048576f);
let _e19371 = ((_e19361 * select(1f, _e19368, _e19367)) + 0.5f);
let _e19373 = select(-1073741800f, _e19371, (_e19371 > -1073741800f));
let _e19375 = select(1073741800f, _e19373, (_e19373 < 1073741800f));
let _e19382 = select(0i, select(select(i32(_e19375), i32(-2147483648), (_e19375 < -2147483600f)), 2147483647i, (_e19375 > 2147483500f)), (_e19375 == _e19375));
let _e19386 = (_e19382 - select(0i, 1i, (_e19375 < f32(_e19382))));
let _e19387 = select(0i, 20i, _e19367);
let _e19391 = (bitcast<u32>(_e19386) << bitcast<u32>((_e19387 & 31i)));
let _e19398 = bitcast<u32>(((_e19386 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19387) & 31i))));
let _e19402 = (bitcast<f32>((bitcast<u32>(_e19362) & 2147483647u)) >= 1073741800f);
let _e19405 = ((_e19362 * select(1f, _e19368, _e19402)) + 0.5f);
let _e19407 = select(-1073741800f, _e19405, (_e19405 > -1073741800f));
let _e19409 = select(1073741800f, _e19407, (_e19407 < 1073741800f));
let _e19416 = select(0i, select(select(i32(_e19409), i32(-2147483648), (_e19409 < -2147483600f)), 2147483647i, (_e19409 > 2147483500f)), (_e19409 == _e19409));
let _e19420 = (_e19416 - select(0i, 1i, (_e19409 < f32(_e19416))));
let _e19421 = select(0i, 20i, _e19402);
let _e19425 = (bitcast<u32>(_e19420) << bitcast<u32>((_e19421 & 31i)));
let _e19432 = bitcast<u32>(((_e19420 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19421) & 31i))));
let _e19436 = (bitcast<f32>((bitcast<u32>(_e19363) & 2147483647u)) >= 1073741800f);
let _e19439 = ((_e19363 * select(1f, _e19368, _e19436)) + 0.5f);
let _e19441 = select(-1073741800f, _e19439, (_e19439 > -1073741800f));
let _e19443 = select(1073741800f, _e19441, (_e19441 < 1073741800f));
let _e19450 = select(0i, select(select(i32(_e19443), i32(-2147483648), (_e19443 < -2147483600f)), 2147483647i, (_e19443 > 2147483500f)), (_e19443 == _e19443));
let _e19454 = (_e19450 - select(0i, 1i, (_e19443 < f32(_e19450))));
let _e19455 = select(0i, 20i, _e19436);
let _e19459 = (bitcast<u32>(_e19454) << bitcast<u32>((_e19455 & 31i)));
let _e19466 = bitcast<u32>(((_e19454 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19455) & 31i))));
let _e19471 = bitcast<i32>(bitcast<u32>((((_e19350.member_1 * _e11931) + _e19350.member) * 6i)));
if ((_e19391 | _e19398) == 0u) {
} else {
let _e19474 = bitcast<u32>(_e19471);
if (_e19474 < _e288) {
let _e19478 = atomicAdd((&global_8.member[_e19474]), _e19391);
phi_31803_ = _e19478;
} else {
phi_31803_ = 0u;
}
let _e19480 = phi_31803_;
let _e19484 = (_e19398 + select(0u, 1u, ((_e19480 + _e19391) < _e19391)));
if (_e19484 == 0u) {
} else {
let _e19486 = (_e19474 + 1u);
if (_e19486 < _e288) {
let _e19490 = atomicAdd((&global_8.member[_e19486]), _e19484);
}
}
}
if ((_e19425 | _e19432) == 0u) {
} else {
let _e19494 = bitcast<u32>((_e19471 + 2i));
if (_e19494 < _e288) {
let _e19498 = atomicAdd((&global_8.member[_e19494]), _e19425);
phi_31833_ = _e19498;
} else {
phi_31833_ = 0u;
}
let _e19500 = phi_31833_;
let _e19504 = (_e19432 + select(0u, 1u, ((_e19500 + _e19425) < _e19425)));
if (_e19504 == 0u) {
} else {
let _e19506 = (_e19494 + 1u);
if (_e19506 < _e288) {
let _e19510 = atomicAdd((&global_8.member[_e19506]), _e19504);
}
}
}
if ((_e19459 | _e19466) == 0u) {
} else {
let _e19514 = bitcast<u32>((_e19471 + 4i));
if (_e19514 < _e288) {
let _e19518 = atomicAdd((&global_8.member[_e19514]), _e19459);
phi_31863_ = _e19518;
} else {
phi_31863_ = 0u;
}
let _e19520 = phi_31863_;
let _e19524 = (_e19466 + select(0u, 1u, ((_e19520 + _e19459) < _e19459)));
if (_e19524 == 0u) {
} else {
let _e19526 = (_e19514 + 1u);
if (_e19526 < _e288) {
let _e19530 = atomicAdd((&global_8.member[_e19526]), _e19524);
}
}
}
phi_30185_ = (_e18474 + 1i);
} else {
phi_30185_ = i32();
}
let _e19533 = phi_30185_;
continue;
continuing {
phi_30184_ = _e19533;
break if !(_e18477);
}
}
phi_30031_ = (_e18380 + 1i);
} else {
phi_30031_ = i32();
}
let _e19537 = phi_30031_;
continue;
continuing {
phi_30030_ = _e19537;
break if !(_e18381);
}
}
} else {
if (_e13346 == 1u) {
phi_31912_ = 0i;
loop {
let _e16528 = phi_31912_;
let _e16529 = (_e16528 < 16i);
if _e16529 {
let _e16531 = (_e11976 + (_e16528 & 15i));
let _e16533 = (f32(_e16531) + 0.5f);
let _e16535 = ((_e16533 * 1f) - 0.5f);
let _e16539 = (-(((_e434 * _e16535) + _e460)) / _e447);
let _e16546 = bitcast<f32>((bitcast<u32>(((_e484 * _e16535) + ((_e497 * _e16539) + _e510))) & 2147483647u));
let _e16553 = bitcast<f32>((bitcast<u32>(((_e523 * _e16535) + ((_e536 * _e16539) + _e549))) & 2147483647u));
let _e16557 = (((0.5f * (_e16546 + _e16553)) / _e552) + _e735);
let _e16558 = (1f / 1f);
let _e16566 = ((((_e16539 + _e16557) + 0.5f) * _e16558) - 0.5f);
let _e16567 = f32(_e13332);
let _e16568 = f32(_e13330);
let _e16569 = (_e16567 - 1f);
let _e16571 = select(_e16569, _e16566, (_e16566 > _e16569));
let _e16573 = select(_e16568, _e16571, (_e16571 < _e16568));
let _e16580 = select(0i, select(select(i32(_e16573), i32(-2147483648), (_e16573 < -2147483600f)), 2147483647i, (_e16573 > 2147483500f)), (_e16573 == _e16573));
let _e16585 = (((((_e16539 - _e16557) + 0.5f) * _e16558) - 0.5f) + 1f);
let _e16586 = (_e16568 + 1f);
let _e16588 = select(_e16567, _e16585, (_e16585 > _e16567));
let _e16590 = select(_e16586, _e16588, (_e16588 < _e16586));
let _e16597 = select(0i, select(select(i32(_e16590), i32(-2147483648), (_e16590 < -2147483600f)), 2147483647i, (_e16590 > 2147483500f)), (_e16590 == _e16590));
let _e16608 = ((1e-4f * 1f) * _e552);
let _e16610 = select(_e16553, _e16546, (_e16546 > _e16553));
let _e16612 = select(_e16608, _e16610, (_e16610 > _e16608));
let _e16614 = select(_e16553, _e16546, (_e16546 < _e16553));
let _e16616 = select(_e16608, _e16614, (_e16614 > _e16608));
let _e16618 = (0.5f * (_e16612 + _e16616));
let _e16619 = (0.5f / _e16616);
let _e16620 = (1f / _e16612);
phi_32066_ = 0i;
loop {
let _e16622 = phi_32066_;
let _e16624 = (((_e16597 - select(0i, 1i, (_e16590 < f32(_e16597)))) + (_e16528 >> bitcast<u32>(4u))) + bitcast<i32>(_e16622));
let _e16625 = (_e16624 <= select(-1i, (_e16580 - select(0i, 1i, (_e16573 < f32(_e16580)))), (_e16531 <= _e11980)));
if _e16625 {
let _e16627 = (f32(_e16624) + 0.5f);
let _e16631 = ((((_e16627 * 1f) - 0.5f) - _e16539) * _e552);
let _e16632 = (_e552 * 1f);
let _e16634 = (0.5f * _e16632);
let _e16635 = (_e16631 + _e16634);
let _e16636 = -(_e16635);
let _e16639 = (_e16618 - select(_e16636, _e16635, (_e16635 > _e16636)));
let _e16641 = select(0f, _e16639, (_e16639 > 0f));
let _e16643 = select(_e16616, _e16641, (_e16641 < _e16616));
let _e16646 = (_e16639 - _e16616);
let _e16650 = (((_e16643 * (_e16643 * _e16619)) + select(0f, _e16646, (_e16646 > 0f))) * _e16620);
let _e16654 = (_e16631 - _e16634);
let _e16655 = -(_e16654);
let _e16658 = (_e16618 - select(_e16655, _e16654, (_e16654 > _e16655)));
let _e16660 = select(0f, _e16658, (_e16658 > 0f));
let _e16662 = select(_e16616, _e16660, (_e16660 < _e16616));
let _e16665 = (_e16658 - _e16616);
let _e16669 = (((_e16662 * (_e16662 * _e16619)) + select(0f, _e16665, (_e16665 > 0f))) * _e16620);
if _e471 {
phi_32171_ = type_26(_e16624, _e16531);
} else {
phi_32171_ = type_26(_e16531, _e16624);
}
let _e16678 = phi_32171_;
let _e16682 = bitcast<i32>((_e11927 * _e11930));
local_130 = _e16682;
local_131 = ((_e16678.member_1 * _e11931) + _e16678.member);
let _e16685 = local_130;
let _e16686 = local_131;
let _e16687 = (_e16685 + _e16686);
let _e16689 = (bitcast<i32>(_e277) - 1i);
let _e16691 = select(_e16689, _e16687, (_e16687 < _e16689));
let _e16696 = global_5.member[bitcast<u32>(select(0i, _e16691, (_e16691 > 0i)))];
let _e16697 = local_130;
let _e16699 = local_131;
let _e16700 = ((2i * _e16697) + _e16699);
let _e16702 = select(_e16689, _e16700, (_e16700 < _e16689));
let _e16707 = global_5.member[bitcast<u32>(select(0i, _e16702, (_e16702 > 0i)))];
let _e16708 = local_131;
let _e16710 = select(_e16689, _e16708, (_e16708 < _e16689));
let _e16715 = global_5.member[bitcast<u32>(select(0i, _e16710, (_e16710 > 0i)))];
let _e16716 = local_131;
let _e16719 = f32(_e11931);
let _e16720 = f32(_e11932);
let _e16727 = global_1.member.member_2.member;
let _e16728 = (((((f32(_e16678.member) + 0.5f) / _e16719) * 2f) - 1f) * _e16727);
let _e16735 = global_1.member.member_2.member_1;
let _e16736 = ((1f - (((f32(_e16678.member_1) + 0.5f) / _e16720) * 2f)) * _e16735);
let _e16738 = global_1.member.member_3;
let _e16746 = global_1.member.member_4;
let _e16753 = ((_e16738.member * _e16728) + (_e16746.member * _e16736));
let _e16754 = ((_e16738.member_1 * _e16728) + (_e16746.member_1 * _e16736));
let _e16755 = ((_e16738.member_2 * _e16728) + (_e16746.member_2 * _e16736));
let _e16758 = global_1.member.member_2.member_3;
let _e16759 = (_e16758 != 0u);
let _e16761 = global_1.member.member_5;
let _e16768 = select((_e16761.member + _e16753), _e16761.member, _e16759);
let _e16769 = select((_e16761.member_1 + _e16754), _e16761.member_1, _e16759);
let _e16770 = select((_e16761.member_2 + _e16755), _e16761.member_2, _e16759);
let _e16772 = global_1.member.member_6;
let _e16779 = select(_e16772.member, (_e16772.member + _e16753), _e16759);
let _e16780 = select(_e16772.member_1, (_e16772.member_1 + _e16754), _e16759);
let _e16781 = select(_e16772.member_2, (_e16772.member_2 + _e16755), _e16759);
let _e16786 = (((_e16768 * _e16768) + (_e16769 * _e16769)) + (_e16770 * _e16770));
let _e16789 = sqrt(select(0f, _e16786, (_e16786 > 0f)));
let _e16790 = (1f / _e16789);
let _e16791 = (_e16768 * _e16790);
let _e16792 = (_e16769 * _e16790);
let _e16793 = (_e16770 * _e16790);
let _e16794 = (_e593 - _e16779);
let _e16795 = (_e605 - _e16780);
let _e16796 = (_e618 - _e16781);
let _e16801 = (((_e16794 * _e16791) + (_e16795 * _e16792)) + (_e16796 * _e16793));
let _e16806 = (((_e16794 * _e631) + (_e16795 * _e644)) + (_e16796 * _e657));
let _e16811 = (((_e16791 * _e631) + (_e16792 * _e644)) + (_e16793 * _e657));
let _e16814 = ((_e16792 * _e657) - (_e16793 * _e644));
let _e16817 = ((_e16793 * _e631) - (_e16791 * _e657));
let _e16820 = ((_e16791 * _e644) - (_e16792 * _e631));
let _e16825 = (((_e16814 * _e16814) + (_e16817 * _e16817)) + (_e16820 * _e16820));
let _e16828 = (1f / select(1e-9f, _e16825, (_e16825 > 1e-9f)));
let _e16831 = ((_e16801 - (_e16811 * _e16806)) * _e16828);
let _e16834 = (((_e16811 * _e16801) - _e16806) * _e16828);
let _e16840 = -(_e16811);
let _e16843 = global_1.member.member_13.member_2;
let _e16844 = (_e16843 * _e16843);
let _e16848 = ((1f + _e16844) - ((2f * _e16843) * _e16840));
let _e16850 = select(1e-9f, _e16848, (_e16848 > 1e-9f));
let _e16862 = global_1.member.member_13.member_3;
if (_e16862 == 2u) {
let _e16867 = (0.5f - (0.5f * _e16840));
let _e16869 = select(0f, _e16867, (_e16867 > 0f));
let _e16873 = (sqrt(select(0f, _e16869, (_e16869 > 0f))) * 255f);
let _e16874 = (255f - 1f);
let _e16876 = select(0f, _e16873, (_e16873 > 0f));
let _e16878 = select(_e16874, _e16876, (_e16876 < _e16874));
let _e16885 = select(0i, select(select(i32(_e16878), i32(-2147483648), (_e16878 < -2147483600f)), 2147483647i, (_e16878 > 2147483500f)), (_e16878 == _e16878));
let _e16889 = (_e16885 - select(0i, 1i, (_e16878 < f32(_e16885))));
let _e16892 = global_1.member.member_13.member_11;
let _e16893 = bitcast<i32>(_e16892);
let _e16894 = (_e16893 + _e16889);
let _e16896 = (bitcast<i32>(_e283) - 1i);
let _e16898 = select(_e16896, _e16894, (_e16894 < _e16896));
let _e16903 = global_2.member[bitcast<u32>(select(0i, _e16898, (_e16898 > 0i)))];
let _e16905 = (_e16893 + (_e16889 + 1i));
let _e16907 = select(_e16896, _e16905, (_e16905 < _e16896));
let _e16912 = global_2.member[bitcast<u32>(select(0i, _e16907, (_e16907 > 0i)))];
phi_32598_ = (_e16903 + ((_e16912 - _e16903) * (_e16873 - f32(_e16889))));
} else {
phi_32598_ = select(((1f - _e16844) / (_e16850 * sqrt(select(0f, _e16850, (_e16850 > 0f))))), (0.75f * (1f + (_e16840 * _e16840))), (_e16862 == 1u));
}
let _e16919 = phi_32598_;
let _e16931 = global_1.member.member_13.member_7;
let _e16932 = bitcast<i32>(_e16931);
let _e16935 = global_1.member.member_13.member_8;
let _e16936 = bitcast<i32>(_e16935);
let _e16939 = global_1.member.member_13.member_9;
let _e16940 = bitcast<i32>(_e16939);
let _e16943 = global_1.member.member_13.member_4;
let _e16949 = global_1.member.member_13.member_5;
let _e16953 = f32(_e16932);
let _e16958 = (((((_e16779 + (_e16791 * _e16831)) - _e16943.member) / (_e16949.member - _e16943.member)) * _e16953) - 0.5f);
let _e16959 = (_e16953 - 1f);
let _e16961 = select(0f, _e16958, (_e16958 > 0f));
let _e16963 = select(_e16959, _e16961, (_e16961 < _e16959));
let _e16964 = f32(_e16936);
let _e16969 = (((((_e16780 + (_e16792 * _e16831)) - _e16943.member_1) / (_e16949.member_1 - _e16943.member_1)) * _e16964) - 0.5f);
let _e16970 = (_e16964 - 1f);
let _e16972 = select(0f, _e16969, (_e16969 > 0f));
let _e16974 = select(_e16970, _e16972, (_e16972 < _e16970));
let _e16975 = f32(_e16940);
let _e16980 = (((((_e16781 + (_e16793 * _e16831)) - _e16943.member_2) / (_e16949.member_2 - _e16943.member_2)) * _e16975) - 0.5f);
let _e16981 = (_e16975 - 1f);
let _e16983 = select(0f, _e16980, (_e16980 > 0f));
let _e16985 = select(_e16981, _e16983, (_e16983 < _e16981));
let _e16987 = select(0f, _e16963, (_e16963 > 0f));
let _e16989 = select(1e6f, _e16987, (_e16987 < 1e6f));
let _e16996 = select(0i, select(select(i32(_e16989), i32(-2147483648), (_e16989 < -2147483600f)), 2147483647i, (_e16989 > 2147483500f)), (_e16989 == _e16989));
let _e17000 = (_e16996 - select(0i, 1i, (_e16989 < f32(_e16996))));
let _e17002 = select(0f, _e16974, (_e16974 > 0f));
let _e17004 = select(1e6f, _e17002, (_e17002 < 1e6f));
let _e17011 = select(0i, select(select(i32(_e17004), i32(-2147483648), (_e17004 < -2147483600f)), 2147483647i, (_e17004 > 2147483500f)), (_e17004 == _e17004));
let _e17015 = (_e17011 - select(0i, 1i, (_e17004 < f32(_e17011))));
let _e17017 = select(0f, _e16985, (_e16985 > 0f));
let _e17019 = select(1e6f, _e17017, (_e17017 < 1e6f));
let _e17026 = select(0i, select(select(i32(_e17019), i32(-2147483648), (_e17019 < -2147483600f)), 2147483647i, (_e17019 > 2147483500f)), (_e17019 == _e17019));
let _e17030 = (_e17026 - select(0i, 1i, (_e17019 < f32(_e17026))));
let _e17034 = (_e16974 - f32(_e17015));
let _e17036 = (_e16985 - f32(_e17030));
local_128 = (_e16963 - f32(_e17000));
let _e17037 = (_e17000 + 1i);
let _e17039 = select(_e17037, 0i, (_e17037 < 0i));
if (_e17039 >= _e16932) {
phi_32730_ = (_e16932 - 1i);
} else {
phi_32730_ = _e17039;
}
let _e17043 = phi_32730_;
local_129 = (_e17043 - _e17000);
let _e17045 = (_e17015 + 1i);
let _e17047 = select(_e17045, 0i, (_e17045 < 0i));
if (_e17047 >= _e16936) {
phi_32743_ = (_e16936 - 1i);
} else {
phi_32743_ = _e17047;
}
let _e17051 = phi_32743_;
let _e17053 = ((_e17051 - _e17015) * _e16932);
let _e17054 = (_e17030 + 1i);
let _e17056 = select(_e17054, 0i, (_e17054 < 0i));
if (_e17056 >= _e16940) {
phi_32757_ = (_e16940 - 1i);
} else {
phi_32757_ = _e17056;
}
let _e17060 = phi_32757_;
let _e17066 = global_1.member.member_13.member_10;
let _e17072 = ((bitcast<i32>(_e17066) + (((_e17030 * _e16936) + _e17015) * _e16932)) + _e17000);
let _e17074 = (bitcast<i32>(_e283) - 1i);
let _e17076 = select(_e17074, _e17072, (_e17072 < _e17074));
let _e17081 = global_2.member[bitcast<u32>(select(0i, _e17076, (_e17076 > 0i)))];
let _e17082 = local_128;
let _e17085 = local_129;
let _e17086 = (_e17072 + _e17085);
let _e17088 = select(_e17074, _e17086, (_e17086 < _e17074));
let _e17093 = global_2.member[bitcast<u32>(select(0i, _e17088, (_e17088 > 0i)))];
let _e17094 = local_128;
let _e17097 = (1f - _e17034);
let _e17099 = (_e17072 + _e17053);
let _e17101 = select(_e17074, _e17099, (_e17099 < _e17074));
let _e17106 = global_2.member[bitcast<u32>(select(0i, _e17101, (_e17101 > 0i)))];
let _e17107 = local_128;
let _e17110 = local_129;
let _e17111 = (_e17099 + _e17110);
let _e17113 = select(_e17074, _e17111, (_e17111 < _e17074));
let _e17118 = global_2.member[bitcast<u32>(select(0i, _e17113, (_e17113 > 0i)))];
let _e17119 = local_128;
let _e17124 = (_e17072 + (((_e17060 - _e17030) * _e16932) * _e16936));
let _e17126 = select(_e17074, _e17124, (_e17124 < _e17074));
let _e17131 = global_2.member[bitcast<u32>(select(0i, _e17126, (_e17126 > 0i)))];
let _e17132 = local_128;
let _e17135 = local_129;
let _e17136 = (_e17124 + _e17135);
let _e17138 = select(_e17074, _e17136, (_e17136 < _e17074));
let _e17143 = global_2.member[bitcast<u32>(select(0i, _e17138, (_e17138 > 0i)))];
let _e17144 = local_128;
let _e17148 = (_e17124 + _e17053);
let _e17150 = select(_e17074, _e17148, (_e17148 < _e17074));
let _e17155 = global_2.member[bitcast<u32>(select(0i, _e17150, (_e17150 > 0i)))];
let _e17156 = local_128;
let _e17159 = local_129;
let _e17160 = (_e17148 + _e17159);
let _e17162 = select(_e17074, _e17160, (_e17160 < _e17074));
let _e17167 = global_2.member[bitcast<u32>(select(0i, _e17162, (_e17162 > 0i)))];
let _e17168 = local_128;
let _e17177 = ((_e16789 * (_e16919 * (0.25f / 3.1415927f))) * ((((((_e17081 * (1f - _e17082)) + (_e17093 * _e17094)) * _e17097) + (((_e17106 * (1f - _e17107)) + (_e17118 * _e17119)) * _e17034)) * (1f - _e17036)) + (((((_e17131 * (1f - _e17132)) + (_e17143 * _e17144)) * _e17097) + (((_e17155 * (1f - _e17156)) + (_e17167 * _e17168)) * _e17034)) * _e17036)));
let _e17180 = global_1.member.member_12.member_12;
let _e17183 = global_1.member.member_12.member_4;
let _e17186 = global_1.member.member_12.member_13;
let _e17192 = global_1.member.member.member;
let _e17194 = (_e16834 / _e709);
local_125 = bitcast<i32>((_e17180 + (_e17183 * _e17186)));
local_126 = _e299;
local_127 = bitcast<i32>(_e17192);
let _e17197 = global_1.member.member_13.member_6;
let _e17198 = f32(_e17197);
let _e17200 = select(0f, _e17194, (_e17194 > 0f));
let _e17203 = (select(1f, _e17200, (_e17200 < 1f)) * _e17198);
let _e17204 = (_e17198 - 1f);
let _e17206 = select(0f, _e17204, (_e17204 > 0f));
let _e17208 = select(0f, _e17203, (_e17203 > 0f));
let _e17210 = select(_e17206, _e17208, (_e17208 < _e17206));
let _e17217 = select(0i, select(select(i32(_e17210), i32(-2147483648), (_e17210 < -2147483600f)), 2147483647i, (_e17210 > 2147483500f)), (_e17210 == _e17210));
let _e17221 = (_e17217 - select(0i, 1i, (_e17210 < f32(_e17217))));
if (_e17221 > 0i) {
let _e17224 = local_125;
let _e17225 = local_127;
let _e17228 = local_126;
let _e17229 = ((_e17224 + ((_e17221 - 1i) * _e17225)) + _e17228);
let _e17231 = (bitcast<i32>(_e286) - 1i);
let _e17233 = select(_e17231, _e17229, (_e17229 < _e17231));
let _e17238 = global_7.member[bitcast<u32>(select(0i, _e17233, (_e17233 > 0i)))];
phi_33061_ = _e17238;
} else {
phi_33061_ = 0f;
}
let _e17240 = phi_33061_;
let _e17241 = local_125;
let _e17242 = local_127;
let _e17245 = local_126;
let _e17246 = ((_e17241 + (_e17221 * _e17242)) + _e17245);
let _e17248 = (bitcast<i32>(_e286) - 1i);
let _e17250 = select(_e17248, _e17246, (_e17246 < _e17248));
let _e17255 = global_7.member[bitcast<u32>(select(0i, _e17250, (_e17250 > 0i)))];
let _e17262 = (_e16707 - _e16696);
let _e17265 = ((_e16831 - _e16696) / select(1e-9f, _e17262, (_e17262 > 1e-9f)));
local_122 = 0i;
local_123 = _e16716;
local_124 = _e16682;
let _e17267 = select(0f, _e17265, (_e17265 > 0f));
let _e17270 = (select(1f, _e17267, (_e17267 < 1f)) * _e17198);
let _e17272 = select(0f, _e17270, (_e17270 > 0f));
let _e17274 = select(_e17206, _e17272, (_e17272 < _e17206));
let _e17281 = select(0i, select(select(i32(_e17274), i32(-2147483648), (_e17274 < -2147483600f)), 2147483647i, (_e17274 > 2147483500f)), (_e17274 == _e17274));
let _e17285 = (_e17281 - select(0i, 1i, (_e17274 < f32(_e17281))));
if (_e17285 > 0i) {
let _e17288 = local_122;
let _e17289 = local_124;
let _e17292 = local_123;
let _e17293 = ((_e17288 + ((_e17285 - 1i) * _e17289)) + _e17292);
let _e17295 = select(_e17248, _e17293, (_e17293 < _e17248));
let _e17300 = global_7.member[bitcast<u32>(select(0i, _e17295, (_e17295 > 0i)))];
phi_33188_ = _e17300;
} else {
phi_33188_ = 0f;
}
let _e17302 = phi_33188_;
let _e17303 = local_122;
let _e17304 = local_124;
let _e17307 = local_123;
let _e17308 = ((_e17303 + (_e17285 * _e17304)) + _e17307);
let _e17310 = select(_e17248, _e17308, (_e17308 < _e17248));
let _e17315 = global_7.member[bitcast<u32>(select(0i, _e17310, (_e17310 > 0i)))];
let _e17321 = ((_e17240 + ((_e17255 - _e17240) * (_e17203 - f32(_e17221)))) + (_e17302 + ((_e17315 - _e17302) * (_e17270 - f32(_e17285)))));
let _e17324 = global_1.member.member_13.member;
let _e17329 = -((_e17324.member * _e17321));
let _e17331 = select(-87f, _e17329, (_e17329 > -87f));
let _e17333 = select(88f, _e17331, (_e17331 < 88f));
let _e17335 = ((_e17333 * 1.442695f) + 0.5f);
let _e17337 = select(-127f, _e17335, (_e17335 > -127f));
let _e17339 = select(128f, _e17337, (_e17337 < 128f));
let _e17346 = select(0i, select(select(i32(_e17339), i32(-2147483648), (_e17339 < -2147483600f)), 2147483647i, (_e17339 > 2147483500f)), (_e17339 == _e17339));
let _e17350 = (_e17346 - select(0i, 1i, (_e17339 < f32(_e17346))));
let _e17351 = f32(_e17350);
let _e17355 = ((_e17333 - (_e17351 * 0.6933594f)) - (_e17351 * -2.1219444e-4f));
let _e17377 = -((_e17324.member_1 * _e17321));
let _e17379 = select(-87f, _e17377, (_e17377 > -87f));
let _e17381 = select(88f, _e17379, (_e17379 < 88f));
let _e17383 = ((_e17381 * 1.442695f) + 0.5f);
let _e17385 = select(-127f, _e17383, (_e17383 > -127f));
let _e17387 = select(128f, _e17385, (_e17385 < 128f));
let _e17394 = select(0i, select(select(i32(_e17387), i32(-2147483648), (_e17387 < -2147483600f)), 2147483647i, (_e17387 > 2147483500f)), (_e17387 == _e17387));
let _e17398 = (_e17394 - select(0i, 1i, (_e17387 < f32(_e17394))));
let _e17399 = f32(_e17398);
let _e17403 = ((_e17381 - (_e17399 * 0.6933594f)) - (_e17399 * -2.1219444e-4f));
let _e17425 = -((_e17324.member_2 * _e17321));
let _e17427 = select(-87f, _e17425, (_e17425 > -87f));
let _e17429 = select(88f, _e17427, (_e17427 < 88f));
let _e17431 = ((_e17429 * 1.442695f) + 0.5f);
let _e17433 = select(-127f, _e17431, (_e17431 > -127f));
let _e17435 = select(128f, _e17433, (_e17433 < 128f));
let _e17442 = select(0i, select(select(i32(_e17435), i32(-2147483648), (_e17435 < -2147483600f)), 2147483647i, (_e17435 > 2147483500f)), (_e17435 == _e17435));
let _e17446 = (_e17442 - select(0i, 1i, (_e17435 < f32(_e17442))));
let _e17447 = f32(_e17446);
let _e17451 = ((_e17429 - (_e17447 * 0.6933594f)) - (_e17447 * -2.1219444e-4f));
let _e17474 = global_1.member.member_13.member_1;
let _e17487 = select(0f, _e16831, (((_e16834 >= 0f) && (_e16834 < _e709)) && (_e16831 > 0f)));
let _e17489 = ((_e784 + _e13334) + _e13338);
let _e17490 = (_e17489 & 31u);
let _e17492 = (1u << bitcast<u32>(_e17490));
let _e17501 = bitcast<i32>((((_e11927 + _e17492) - 1u) >> bitcast<u32>(_e17490)));
let _e17502 = bitcast<i32>((((_e11930 + _e17492) - 1u) >> bitcast<u32>(_e17490)));
if _e471 {
phi_33478_ = type_26(_e17502, _e17501);
} else {
phi_33478_ = type_26(_e17501, _e17502);
}
let _e17506 = phi_33478_;
let _e17511 = f32((1i << bitcast<u32>(_e17490)));
let _e17512 = (1f / _e17511);
let _e17514 = ((_e16533 * _e17512) - 0.5f);
let _e17516 = ((_e16627 * _e17512) - 0.5f);
let _e17518 = select(-1f, _e17514, (_e17514 > -1f));
let _e17520 = select(1e6f, _e17518, (_e17518 < 1e6f));
let _e17527 = select(0i, select(select(i32(_e17520), i32(-2147483648), (_e17520 < -2147483600f)), 2147483647i, (_e17520 > 2147483500f)), (_e17520 == _e17520));
let _e17531 = (_e17527 - select(0i, 1i, (_e17520 < f32(_e17527))));
let _e17533 = select(-1f, _e17516, (_e17516 > -1f));
let _e17535 = select(1e6f, _e17533, (_e17533 < 1e6f));
let _e17542 = select(0i, select(select(i32(_e17535), i32(-2147483648), (_e17535 < -2147483600f)), 2147483647i, (_e17535 > 2147483500f)), (_e17535 == _e17535));
let _e17546 = (_e17542 - select(0i, 1i, (_e17535 < f32(_e17542))));
let _e17548 = (_e17514 - f32(_e17531));
let _e17550 = (_e17516 - f32(_e17546));
let _e17551 = (1f - _e17548);
let _e17552 = (1f - _e17550);
let _e17555 = select(_e17531, 0i, (_e17531 < 0i));
let _e17556 = (_e17555 >= _e17506.member);
if _e17556 {
phi_33556_ = (_e17506.member - 1i);
} else {
phi_33556_ = _e17555;
}
let _e17559 = phi_33556_;
let _e17561 = select(_e17546, 0i, (_e17546 < 0i));
let _e17562 = (_e17561 >= _e17506.member_1);
if _e17562 {
phi_33567_ = (_e17506.member_1 - 1i);
} else {
phi_33567_ = _e17561;
}
let _e17565 = phi_33567_;
let _e17569 = (((f32(_e17559) + 0.5f) * _e17511) - 0.5f);
let _e17573 = (((f32(_e17565) + 0.5f) * _e17511) - 0.5f);
if _e471 {
phi_33595_ = type_26(_e17565, _e17559);
} else {
phi_33595_ = type_26(_e17559, _e17565);
}
let _e17579 = phi_33595_;
let _e17585 = bitcast<i32>(((_e11927 + 1u) >> bitcast<u32>(1u)));
let _e17588 = global_1.member.member_18.member_6;
let _e17591 = global_1.member.member_18.member_7;
let _e17594 = global_1.member.member_18.member_8;
let _e17595 = (_e17489 == 0u);
if _e17595 {
phi_33646_ = 0u;
} else {
if (_e17489 == 1u) {
phi_33645_ = 0u;
} else {
if (_e17489 == 2u) {
phi_33644_ = _e17588;
} else {
phi_33644_ = select(_e17594, _e17591, (_e17489 == 3u));
}
let _e17601 = phi_33644_;
phi_33645_ = _e17601;
}
let _e17603 = phi_33645_;
phi_33646_ = _e17603;
}
let _e17605 = phi_33646_;
local_120 = (((bitcast<i32>(_e17605) + _e17579.member_1) * _e17585) + _e17579.member);
let _e17610 = local_120;
let _e17612 = (bitcast<i32>(_e280) - 1i);
let _e17614 = select(_e17612, _e17610, (_e17610 < _e17612));
let _e17619 = global_6.member[bitcast<u32>(select(0i, _e17614, (_e17614 > 0i)))];
let _e17624 = (((((select(_e17569, _e17573, _e471) + 0.5f) / _e16719) * 2f) - 1f) * _e16727);
let _e17629 = ((1f - (((select(_e17573, _e17569, _e471) + 0.5f) / _e16720) * 2f)) * _e16735);
let _e17636 = ((_e16738.member * _e17624) + (_e16746.member * _e17629));
let _e17637 = ((_e16738.member_1 * _e17624) + (_e16746.member_1 * _e17629));
let _e17638 = ((_e16738.member_2 * _e17624) + (_e16746.member_2 * _e17629));
let _e17642 = select((_e16761.member + _e17636), _e16761.member, _e16759);
let _e17643 = select((_e16761.member_1 + _e17637), _e16761.member_1, _e16759);
let _e17644 = select((_e16761.member_2 + _e17638), _e16761.member_2, _e16759);
let _e17655 = (((_e17642 * _e17642) + (_e17643 * _e17643)) + (_e17644 * _e17644));
let _e17659 = (1f / sqrt(select(0f, _e17655, (_e17655 > 0f))));
let _e17660 = (_e17642 * _e17659);
let _e17661 = (_e17643 * _e17659);
let _e17662 = (_e17644 * _e17659);
let _e17663 = (_e593 - select(_e16772.member, (_e16772.member + _e17636), _e16759));
let _e17664 = (_e605 - select(_e16772.member_1, (_e16772.member_1 + _e17637), _e16759));
let _e17665 = (_e618 - select(_e16772.member_2, (_e16772.member_2 + _e17638), _e16759));
let _e17670 = (((_e17663 * _e17660) + (_e17664 * _e17661)) + (_e17665 * _e17662));
let _e17675 = (((_e17663 * _e631) + (_e17664 * _e644)) + (_e17665 * _e657));
let _e17680 = (((_e17660 * _e631) + (_e17661 * _e644)) + (_e17662 * _e657));
let _e17683 = ((_e17661 * _e657) - (_e17662 * _e644));
let _e17686 = ((_e17662 * _e631) - (_e17660 * _e657));
let _e17689 = ((_e17660 * _e644) - (_e17661 * _e631));
let _e17694 = (((_e17683 * _e17683) + (_e17686 * _e17686)) + (_e17689 * _e17689));
let _e17697 = (1f / select(1e-9f, _e17694, (_e17694 > 1e-9f)));
let _e17700 = ((_e17670 - (_e17680 * _e17675)) * _e17697);
let _e17703 = (((_e17680 * _e17670) - _e17675) * _e17697);
let _e17709 = select(0f, _e17700, (((_e17703 >= 0f) && (_e17703 < _e709)) && (_e17700 > 0f)));
let _e17711 = (_e17559 << bitcast<u32>(_e17490));
let _e17723 = (_e17531 + 1i);
let _e17726 = select(_e17723, 0i, (_e17723 < 0i));
let _e17727 = (_e17726 >= _e17506.member);
if _e17727 {
phi_34630_ = (_e17506.member - 1i);
} else {
phi_34630_ = _e17726;
}
let _e17730 = phi_34630_;
if _e17562 {
phi_34641_ = (_e17506.member_1 - 1i);
} else {
phi_34641_ = _e17561;
}
let _e17733 = phi_34641_;
let _e17737 = (((f32(_e17730) + 0.5f) * _e17511) - 0.5f);
let _e17741 = (((f32(_e17733) + 0.5f) * _e17511) - 0.5f);
if _e471 {
phi_34669_ = type_26(_e17733, _e17730);
} else {
phi_34669_ = type_26(_e17730, _e17733);
}
let _e17747 = phi_34669_;
if _e17595 {
phi_34720_ = 0u;
} else {
if (_e17489 == 1u) {
phi_34719_ = 0u;
} else {
if (_e17489 == 2u) {
phi_34718_ = _e17588;
} else {
phi_34718_ = select(_e17594, _e17591, (_e17489 == 3u));
}
let _e17755 = phi_34718_;
phi_34719_ = _e17755;
}
let _e17757 = phi_34719_;
phi_34720_ = _e17757;
}
let _e17759 = phi_34720_;
local_118 = (((bitcast<i32>(_e17759) + _e17747.member_1) * _e17585) + _e17747.member);
let _e17764 = local_118;
let _e17766 = select(_e17612, _e17764, (_e17764 < _e17612));
let _e17771 = global_6.member[bitcast<u32>(select(0i, _e17766, (_e17766 > 0i)))];
let _e17776 = (((((select(_e17737, _e17741, _e471) + 0.5f) / _e16719) * 2f) - 1f) * _e16727);
let _e17781 = ((1f - (((select(_e17741, _e17737, _e471) + 0.5f) / _e16720) * 2f)) * _e16735);
let _e17788 = ((_e16738.member * _e17776) + (_e16746.member * _e17781));
let _e17789 = ((_e16738.member_1 * _e17776) + (_e16746.member_1 * _e17781));
let _e17790 = ((_e16738.member_2 * _e17776) + (_e16746.member_2 * _e17781));
let _e17794 = select((_e16761.member + _e17788), _e16761.member, _e16759);
let _e17795 = select((_e16761.member_1 + _e17789), _e16761.member_1, _e16759);
let _e17796 = select((_e16761.member_2 + _e17790), _e16761.member_2, _e16759);
let _e17807 = (((_e17794 * _e17794) + (_e17795 * _e17795)) + (_e17796 * _e17796));
let _e17811 = (1f / sqrt(select(0f, _e17807, (_e17807 > 0f))));
let _e17812 = (_e17794 * _e17811);
let _e17813 = (_e17795 * _e17811);
let _e17814 = (_e17796 * _e17811);
let _e17815 = (_e593 - select(_e16772.member, (_e16772.member + _e17788), _e16759));
let _e17816 = (_e605 - select(_e16772.member_1, (_e16772.member_1 + _e17789), _e16759));
let _e17817 = (_e618 - select(_e16772.member_2, (_e16772.member_2 + _e17790), _e16759));
let _e17822 = (((_e17815 * _e17812) + (_e17816 * _e17813)) + (_e17817 * _e17814));
let _e17827 = (((_e17815 * _e631) + (_e17816 * _e644)) + (_e17817 * _e657));
let _e17832 = (((_e17812 * _e631) + (_e17813 * _e644)) + (_e17814 * _e657));
let _e17835 = ((_e17813 * _e657) - (_e17814 * _e644));
let _e17838 = ((_e17814 * _e631) - (_e17812 * _e657));
let _e17841 = ((_e17812 * _e644) - (_e17813 * _e631));
let _e17846 = (((_e17835 * _e17835) + (_e17838 * _e17838)) + (_e17841 * _e17841));
let _e17849 = (1f / select(1e-9f, _e17846, (_e17846 > 1e-9f)));
let _e17852 = ((_e17822 - (_e17832 * _e17827)) * _e17849);
let _e17855 = (((_e17832 * _e17822) - _e17827) * _e17849);
let _e17861 = select(0f, _e17852, (((_e17855 >= 0f) && (_e17855 < _e709)) && (_e17852 > 0f)));
let _e17863 = (_e17730 << bitcast<u32>(_e17490));
let _e17875 = (_e17546 + 1i);
if _e17556 {
phi_35704_ = (_e17506.member - 1i);
} else {
phi_35704_ = _e17555;
}
let _e17879 = phi_35704_;
let _e17881 = select(_e17875, 0i, (_e17875 < 0i));
let _e17882 = (_e17881 >= _e17506.member_1);
if _e17882 {
phi_35715_ = (_e17506.member_1 - 1i);
} else {
phi_35715_ = _e17881;
}
let _e17885 = phi_35715_;
let _e17889 = (((f32(_e17879) + 0.5f) * _e17511) - 0.5f);
let _e17893 = (((f32(_e17885) + 0.5f) * _e17511) - 0.5f);
if _e471 {
phi_35743_ = type_26(_e17885, _e17879);
} else {
phi_35743_ = type_26(_e17879, _e17885);
}
let _e17899 = phi_35743_;
if _e17595 {
phi_35794_ = 0u;
} else {
if (_e17489 == 1u) {
phi_35793_ = 0u;
} else {
if (_e17489 == 2u) {
phi_35792_ = _e17588;
} else {
phi_35792_ = select(_e17594, _e17591, (_e17489 == 3u));
}
let _e17907 = phi_35792_;
phi_35793_ = _e17907;
}
let _e17909 = phi_35793_;
phi_35794_ = _e17909;
}
let _e17911 = phi_35794_;
local_116 = (((bitcast<i32>(_e17911) + _e17899.member_1) * _e17585) + _e17899.member);
let _e17916 = local_116;
let _e17918 = select(_e17612, _e17916, (_e17916 < _e17612));
let _e17923 = global_6.member[bitcast<u32>(select(0i, _e17918, (_e17918 > 0i)))];
let _e17928 = (((((select(_e17889, _e17893, _e471) + 0.5f) / _e16719) * 2f) - 1f) * _e16727);
let _e17933 = ((1f - (((select(_e17893, _e17889, _e471) + 0.5f) / _e16720) * 2f)) * _e16735);
let _e17940 = ((_e16738.member * _e17928) + (_e16746.member * _e17933));
let _e17941 = ((_e16738.member_1 * _e17928) + (_e16746.member_1 * _e17933));
let _e17942 = ((_e16738.member_2 * _e17928) + (_e16746.member_2 * _e17933));
let _e17946 = select((_e16761.member + _e17940), _e16761.member, _e16759);
let _e17947 = select((_e16761.member_1 + _e17941), _e16761.member_1, _e16759);
let _e17948 = select((_e16761.member_2 + _e17942), _e16761.member_2, _e16759);
let _e17959 = (((_e17946 * _e17946) + (_e17947 * _e17947)) + (_e17948 * _e17948));
let _e17963 = (1f / sqrt(select(0f, _e17959, (_e17959 > 0f))));
let _e17964 = (_e17946 * _e17963);
let _e17965 = (_e17947 * _e17963);
let _e17966 = (_e17948 * _e17963);
let _e17967 = (_e593 - select(_e16772.member, (_e16772.member + _e17940), _e16759));
let _e17968 = (_e605 - select(_e16772.member_1, (_e16772.member_1 + _e17941), _e16759));
let _e17969 = (_e618 - select(_e16772.member_2, (_e16772.member_2 + _e17942), _e16759));
let _e17974 = (((_e17967 * _e17964) + (_e17968 * _e17965)) + (_e17969 * _e17966));
let _e17979 = (((_e17967 * _e631) + (_e17968 * _e644)) + (_e17969 * _e657));
let _e17984 = (((_e17964 * _e631) + (_e17965 * _e644)) + (_e17966 * _e657));
let _e17987 = ((_e17965 * _e657) - (_e17966 * _e644));
let _e17990 = ((_e17966 * _e631) - (_e17964 * _e657));
let _e17993 = ((_e17964 * _e644) - (_e17965 * _e631));
let _e17998 = (((_e17987 * _e17987) + (_e17990 * _e17990)) + (_e17993 * _e17993));
let _e18001 = (1f / select(1e-9f, _e17998, (_e17998 > 1e-9f)));
let _e18004 = ((_e17974 - (_e17984 * _e17979)) * _e18001);
let _e18007 = (((_e17984 * _e17974) - _e17979) * _e18001);
let _e18013 = select(0f, _e18004, (((_e18007 >= 0f) && (_e18007 < _e709)) && (_e18004 > 0f)));
let _e18015 = (_e17879 << bitcast<u32>(_e17490));
if _e17727 {
phi_36778_ = (_e17506.member - 1i);
} else {
phi_36778_ = _e17726;
}
let _e18030 = phi_36778_;
if _e17882 {
phi_36789_ = (_e17506.member_1 - 1i);
} else {
phi_36789_ = _e17881;
}
let _e18033 = phi_36789_;
let _e18037 = (((f32(_e18030) + 0.5f) * _e17511) - 0.5f);
let _e18041 = (((f32(_e18033) + 0.5f) * _e17511) - 0.5f);
if _e471 {
phi_36817_ = type_26(_e18033, _e18030);
} else {
phi_36817_ = type_26(_e18030, _e18033);
}
let _e18047 = phi_36817_;
if _e17595 {
phi_36868_ = 0u;
} else {
if (_e17489 == 1u) {
phi_36867_ = 0u;
} else {
if (_e17489 == 2u) {
phi_36866_ = _e17588;
} else {
phi_36866_ = select(_e17594, _e17591, (_e17489 == 3u));
}
let _e18055 = phi_36866_;
phi_36867_ = _e18055;
}
let _e18057 = phi_36867_;
phi_36868_ = _e18057;
}
let _e18059 = phi_36868_;
local_114 = (((bitcast<i32>(_e18059) + _e18047.member_1) * _e17585) + _e18047.member);
let _e18064 = local_114;
let _e18066 = select(_e17612, _e18064, (_e18064 < _e17612));
let _e18071 = global_6.member[bitcast<u32>(select(0i, _e18066, (_e18066 > 0i)))];
let _e18076 = (((((select(_e18037, _e18041, _e471) + 0.5f) / _e16719) * 2f) - 1f) * _e16727);
let _e18081 = ((1f - (((select(_e18041, _e18037, _e471) + 0.5f) / _e16720) * 2f)) * _e16735);
let _e18088 = ((_e16738.member * _e18076) + (_e16746.member * _e18081));
let _e18089 = ((_e16738.member_1 * _e18076) + (_e16746.member_1 * _e18081));
let _e18090 = ((_e16738.member_2 * _e18076) + (_e16746.member_2 * _e18081));
let _e18094 = select((_e16761.member + _e18088), _e16761.member, _e16759);
let _e18095 = select((_e16761.member_1 + _e18089), _e16761.member_1, _e16759);
let _e18096 = select((_e16761.member_2 + _e18090), _e16761.member_2, _e16759);
let _e18107 = (((_e18094 * _e18094) + (_e18095 * _e18095)) + (_e18096 * _e18096));
let _e18111 = (1f / sqrt(select(0f, _e18107, (_e18107 > 0f))));
let _e18112 = (_e18094 * _e18111);
let _e18113 = (_e18095 * _e18111);
let _e18114 = (_e18096 * _e18111);
let _e18115 = (_e593 - select(_e16772.member, (_e16772.member + _e18088), _e16759));
let _e18116 = (_e605 - select(_e16772.member_1, (_e16772.member_1 + _e18089), _e16759));
let _e18117 = (_e618 - select(_e16772.member_2, (_e16772.member_2 + _e18090), _e16759));
let _e18122 = (((_e18115 * _e18112) + (_e18116 * _e18113)) + (_e18117 * _e18114));
let _e18127 = (((_e18115 * _e631) + (_e18116 * _e644)) + (_e18117 * _e657));
let _e18132 = (((_e18112 * _e631) + (_e18113 * _e644)) + (_e18114 * _e657));
let _e18135 = ((_e18113 * _e657) - (_e18114 * _e644));
let _e18138 = ((_e18114 * _e631) - (_e18112 * _e657));
let _e18141 = ((_e18112 * _e644) - (_e18113 * _e631));
let _e18146 = (((_e18135 * _e18135) + (_e18138 * _e18138)) + (_e18141 * _e18141));
let _e18149 = (1f / select(1e-9f, _e18146, (_e18146 > 1e-9f)));
let _e18152 = ((_e18122 - (_e18132 * _e18127)) * _e18149);
let _e18155 = (((_e18132 * _e18122) - _e18127) * _e18149);
let _e18161 = select(0f, _e18152, (((_e18155 >= 0f) && (_e18155 < _e709)) && (_e18152 > 0f)));
let _e18163 = (_e18030 << bitcast<u32>(_e17490));
let _e18175 = select(((((1f - select(0f, (_e17551 * _e17552), (((select(select(_e784, _e941, (_e17711 >= _e710)), _e863, (_e17711 < _e316)) == _e17489) && (_e17709 > 0f)) && (_e17709 < _e17619)))) - select(0f, (_e17548 * _e17552), (((select(select(_e784, _e941, (_e17863 >= _e710)), _e863, (_e17863 < _e316)) == _e17489) && (_e17861 > 0f)) && (_e17861 < _e17771)))) - select(0f, (_e17551 * _e17550), (((select(select(_e784, _e941, (_e18015 >= _e710)), _e863, (_e18015 < _e316)) == _e17489) && (_e18013 > 0f)) && (_e18013 < _e17923)))) - select(0f, (_e17548 * _e17550), (((select(select(_e784, _e941, (_e18163 >= _e710)), _e863, (_e18163 < _e316)) == _e17489) && (_e18161 > 0f)) && (_e18161 < _e18071)))), 1f, _e17595);
if _e471 {
phi_37861_ = type_26(_e16624, _e16531);
} else {
phi_37861_ = type_26(_e16531, _e16624);
}
let _e18190 = phi_37861_;
let _e18193 = (_e16625 && (((_e17487 > 0f) && (_e17487 < _e16715)) && (bitcast<f32>((bitcast<u32>(_e18175) & 2147483647u)) > 1e-6f)));
let _e18196 = global_1.member.member_18.member;
let _e18197 = (((select(_e16650, (1f - _e16650), (_e16635 >= 0f)) - select(_e16669, (1f - _e16669), (_e16654 >= 0f))) * (1f / _e16632)) * _e18196);
let _e18201 = select(0f, (((((_e670 * _e17474.member) * ((1f + (_e17355 * (1f + (_e17355 * (0.5f + (_e17355 * (0.16666667f + (_e17355 * (0.041666668f + (_e17355 * (0.008333334f + (_e17355 * (0.001388889f + (_e17355 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17350 + 127i)) << bitcast<u32>(23i))))) * _e17177) * _e18175) * _e18197), _e18193);
let _e18202 = select(0f, (((((_e683 * _e17474.member_1) * ((1f + (_e17403 * (1f + (_e17403 * (0.5f + (_e17403 * (0.16666667f + (_e17403 * (0.041666668f + (_e17403 * (0.008333334f + (_e17403 * (0.001388889f + (_e17403 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17398 + 127i)) << bitcast<u32>(23i))))) * _e17177) * _e18175) * _e18197), _e18193);
let _e18203 = select(0f, (((((_e696 * _e17474.member_2) * ((1f + (_e17451 * (1f + (_e17451 * (0.5f + (_e17451 * (0.16666667f + (_e17451 * (0.041666668f + (_e17451 * (0.008333334f + (_e17451 * (0.001388889f + (_e17451 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17446 + 127i)) << bitcast<u32>(23i))))) * _e17177) * _e18175) * _e18197), _e18193);
let _e18207 = (bitcast<f32>((bitcast<u32>(_e18201) & 2147483647u)) >= 1073741800f);
let _e18208 = (1f / 1048576f);
let _e18211 = ((_e18201 * select(1f, _e18208, _e18207)) + 0.5f);
let _e18213 = select(-1073741800f, _e18211, (_e18211 > -1073741800f));
let _e18215 = select(1073741800f, _e18213, (_e18213 < 1073741800f));
let _e18222 = select(0i, select(select(i32(_e18215), i32(-2147483648), (_e18215 < -2147483600f)), 2147483647i, (_e18215 > 2147483500f)), (_e18215 == _e18215));
let _e18226 = (_e18222 - select(0i, 1i, (_e18215 < f32(_e18222))));
let _e18227 = select(0i, 20i, _e18207);
let _e18231 = (bitcast<u32>(_e18226) << bitcast<u32>((_e18227 & 31i)));
let _e18238 = bitcast<u32>(((_e18226 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e18227) & 31i))));
let _e18242 = (bitcast<f32>((bitcast<u32>(_e18202) & 2147483647u)) >= 1073741800f);
let _e18245 = ((_e18202 * select(1f, _e18208, _e18242)) + 0.5f);
let _e18247 = select(-1073741800f, _e18245, (_e18245 > -1073741800f));
let _e18249 = select(1073741800f, _e18247, (_e18247 < 1073741800f));
let _e18256 = select(0i, select(select(i32(_e18249), i32(-2147483648), (_e18249 < -2147483600f)), 2147483647i, (_e18249 > 2147483500f)), (_e18249 == _e18249));
let _e18260 = (_e18256 - select(0i, 1i, (_e18249 < f32(_e18256))));
let _e18261 = select(0i, 20i, _e18242);
let _e18265 = (bitcast<u32>(_e18260) << bitcast<u32>((_e18261 & 31i)));
let _e18272 = bitcast<u32>(((_e18260 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e18261) & 31i))));
let _e18276 = (bitcast<f32>((bitcast<u32>(_e18203) & 2147483647u)) >= 1073741800f);
let _e18279 = ((_e18203 * select(1f, _e18208, _e18276)) + 0.5f);
let _e18281 = select(-1073741800f, _e18279, (_e18279 > -1073741800f));
let _e18283 = select(1073741800f, _e18281, (_e18281 < 1073741800f));
let _e18290 = select(0i, select(select(i32(_e18283), i32(-2147483648), (_e18283 < -2147483600f)), 2147483647i, (_e18283 > 2147483500f)), (_e18283 == _e18283));
let _e18294 = (_e18290 - select(0i, 1i, (_e18283 < f32(_e18290))));
let _e18295 = select(0i, 20i, _e18276);
let _e18299 = (bitcast<u32>(_e18294) << bitcast<u32>((_e18295 & 31i)));
let _e18306 = bitcast<u32>(((_e18294 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e18295) & 31i))));
let _e18311 = bitcast<i32>(bitcast<u32>((((_e18190.member_1 * _e11931) + _e18190.member) * 6i)));
if ((_e18231 | _e18238) == 0u) {
} else {
let _e18314 = bitcast<u32>(_e18311);
if (_e18314 < _e288) {
let _e18318 = atomicAdd((&global_8.member[_e18314]), _e18231);
phi_38094_ = _e18318;
} else {
phi_38094_ = 0u;
}
let _e18320 = phi_38094_;
let _e18324 = (_e18238 + select(0u, 1u, ((_e18320 + _e18231) < _e18231)));
if (_e18324 == 0u) {
} else {
let _e18326 = (_e18314 + 1u);
if (_e18326 < _e288) {
let _e18330 = atomicAdd((&global_8.member[_e18326]), _e18324);
}
}
}
if ((_e18265 | _e18272) == 0u) {
} else {
let _e18334 = bitcast<u32>((_e18311 + 2i));
if (_e18334 < _e288) {
let _e18338 = atomicAdd((&global_8.member[_e18334]), _e18265);
phi_38124_ = _e18338;
} else {
phi_38124_ = 0u;
}
let _e18340 = phi_38124_;
let _e18344 = (_e18272 + select(0u, 1u, ((_e18340 + _e18265) < _e18265)));
if (_e18344 == 0u) {
} else {
let _e18346 = (_e18334 + 1u);
if (_e18346 < _e288) {
let _e18350 = atomicAdd((&global_8.member[_e18346]), _e18344);
}
}
}
if ((_e18299 | _e18306) == 0u) {
} else {
let _e18354 = bitcast<u32>((_e18311 + 4i));
if (_e18354 < _e288) {
let _e18358 = atomicAdd((&global_8.member[_e18354]), _e18299);
phi_38154_ = _e18358;
} else {
phi_38154_ = 0u;
}
let _e18360 = phi_38154_;
let _e18364 = (_e18306 + select(0u, 1u, ((_e18360 + _e18299) < _e18299)));
if (_e18364 == 0u) {
} else {
let _e18366 = (_e18354 + 1u);
if (_e18366 < _e288) {
let _e18370 = atomicAdd((&global_8.member[_e18366]), _e18364);
}
}
}
phi_32067_ = (_e16622 + 1i);
} else {
phi_32067_ = i32();
}
let _e18373 = phi_32067_;
continue;
continuing {
phi_32066_ = _e18373;
break if !(_e16625);
}
}
phi_31913_ = (_e16528 + 1i);
} else {
phi_31913_ = i32();
}
let _e18377 = phi_31913_;
continue;
continuing {
phi_31912_ = _e18377;
break if !(_e16529);
}
}
} else {
phi_38199_ = 0i;
loop {
let _e13350 = phi_38199_;
let _e13351 = (_e13350 < 16i);
if _e13351 {
let _e13353 = (_e11976 + (_e13350 & 15i));
let _e13355 = (f32(_e13353) + 0.5f);
let _e13357 = ((_e13355 * 1f) - 0.5f);
let _e13361 = (-(((_e434 * _e13357) + _e460)) / _e447);
let _e13368 = bitcast<f32>((bitcast<u32>(((_e484 * _e13357) + ((_e497 * _e13361) + _e510))) & 2147483647u));
let _e13375 = bitcast<f32>((bitcast<u32>(((_e523 * _e13357) + ((_e536 * _e13361) + _e549))) & 2147483647u));
let _e13379 = (((0.5f * (_e13368 + _e13375)) / _e552) + _e735);
let _e13380 = (1f / 1f);
let _e13388 = ((((_e13361 + _e13379) + 0.5f) * _e13380) - 0.5f);
let _e13389 = f32(_e13332);
let _e13390 = f32(_e13330);
let _e13391 = (_e13389 - 1f);
let _e13393 = select(_e13391, _e13388, (_e13388 > _e13391));
let _e13395 = select(_e13390, _e13393, (_e13393 < _e13390));
let _e13402 = select(0i, select(select(i32(_e13395), i32(-2147483648), (_e13395 < -2147483600f)), 2147483647i, (_e13395 > 2147483500f)), (_e13395 == _e13395));
let _e13407 = (((((_e13361 - _e13379) + 0.5f) * _e13380) - 0.5f) + 1f);
let _e13408 = (_e13390 + 1f);
let _e13410 = select(_e13389, _e13407, (_e13407 > _e13389));
let _e13412 = select(_e13408, _e13410, (_e13410 < _e13408));
let _e13419 = select(0i, select(select(i32(_e13412), i32(-2147483648), (_e13412 < -2147483600f)), 2147483647i, (_e13412 > 2147483500f)), (_e13412 == _e13412));
let _e13430 = ((1e-4f * 1f) * _e552);
let _e13432 = select(_e13375, _e13368, (_e13368 > _e13375));
let _e13434 = select(_e13430, _e13432, (_e13432 > _e13430));
let _e13436 = select(_e13375, _e13368, (_e13368 < _e13375));
let _e13438 = select(_e13430, _e13436, (_e13436 > _e13430));
let _e13440 = (0.5f * (_e13434 + _e13438));
let _e13441 = (0.5f / _e13438);
let _e13442 = (1f / _e13434);
phi_38353_ = 0i;
loop {
let _e13444 = phi_38353_;
let _e13446 = (((_e13419 - select(0i, 1i, (_e13412 < f32(_e13419)))) + (_e13350 >> bitcast<u32>(4u))) + bitcast<i32>(_e13444));
let _e13447 = (_e13446 <= select(-1i, (_e13402 - select(0i, 1i, (_e13395 < f32(_e13402)))), (_e13353 <= _e11980)));
if _e13447 {
let _e13449 = (f32(_e13446) + 0.5f);
let _e13453 = ((((_e13449 * 1f) - 0.5f) - _e13361) * _e552);
let _e13454 = (_e552 * 1f);
let _e13456 = (0.5f * _e13454);
let _e13457 = (_e13453 + _e13456);
let _e13458 = -(_e13457);
let _e13461 = (_e13440 - select(_e13458, _e13457, (_e13457 > _e13458)));
let _e13463 = select(0f, _e13461, (_e13461 > 0f));
let _e13465 = select(_e13438, _e13463, (_e13463 < _e13438));
let _e13468 = (_e13461 - _e13438);
let _e13472 = (((_e13465 * (_e13465 * _e13441)) + select(0f, _e13468, (_e13468 > 0f))) * _e13442);
let _e13476 = (_e13453 - _e13456);
let _e13477 = -(_e13476);
let _e13480 = (_e13440 - select(_e13477, _e13476, (_e13476 > _e13477)));
let _e13482 = select(0f, _e13480, (_e13480 > 0f));
let _e13484 = select(_e13438, _e13482, (_e13482 < _e13438));
let _e13487 = (_e13480 - _e13438);
let _e13491 = (((_e13484 * (_e13484 * _e13441)) + select(0f, _e13487, (_e13487 > 0f))) * _e13442);
if _e471 {
phi_38458_ = type_26(_e13446, _e13353);
} else {
phi_38458_ = type_26(_e13353, _e13446);
}
let _e13500 = phi_38458_;
let _e13504 = bitcast<i32>((_e11927 * _e11930));
local_112 = _e13504;
local_113 = ((_e13500.member_1 * _e11931) + _e13500.member);
let _e13507 = local_112;
let _e13508 = local_113;
let _e13509 = (_e13507 + _e13508);
let _e13511 = (bitcast<i32>(_e277) - 1i);
let _e13513 = select(_e13511, _e13509, (_e13509 < _e13511));
let _e13518 = global_5.member[bitcast<u32>(select(0i, _e13513, (_e13513 > 0i)))];
let _e13519 = local_112;
let _e13521 = local_113;
let _e13522 = ((2i * _e13519) + _e13521);
let _e13524 = select(_e13511, _e13522, (_e13522 < _e13511));
let _e13529 = global_5.member[bitcast<u32>(select(0i, _e13524, (_e13524 > 0i)))];
let _e13530 = local_113;
let _e13532 = select(_e13511, _e13530, (_e13530 < _e13511));
let _e13537 = global_5.member[bitcast<u32>(select(0i, _e13532, (_e13532 > 0i)))];
let _e13538 = local_113;
let _e13541 = f32(_e11931);
let _e13542 = f32(_e11932);
let _e13549 = global_1.member.member_2.member;
let _e13550 = (((((f32(_e13500.member) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e13557 = global_1.member.member_2.member_1;
let _e13558 = ((1f - (((f32(_e13500.member_1) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e13560 = global_1.member.member_3;
let _e13568 = global_1.member.member_4;
let _e13575 = ((_e13560.member * _e13550) + (_e13568.member * _e13558));
let _e13576 = ((_e13560.member_1 * _e13550) + (_e13568.member_1 * _e13558));
let _e13577 = ((_e13560.member_2 * _e13550) + (_e13568.member_2 * _e13558));
let _e13580 = global_1.member.member_2.member_3;
let _e13581 = (_e13580 != 0u);
let _e13583 = global_1.member.member_5;
let _e13590 = select((_e13583.member + _e13575), _e13583.member, _e13581);
let _e13591 = select((_e13583.member_1 + _e13576), _e13583.member_1, _e13581);
let _e13592 = select((_e13583.member_2 + _e13577), _e13583.member_2, _e13581);
let _e13594 = global_1.member.member_6;
let _e13601 = select(_e13594.member, (_e13594.member + _e13575), _e13581);
let _e13602 = select(_e13594.member_1, (_e13594.member_1 + _e13576), _e13581);
let _e13603 = select(_e13594.member_2, (_e13594.member_2 + _e13577), _e13581);
let _e13608 = (((_e13590 * _e13590) + (_e13591 * _e13591)) + (_e13592 * _e13592));
let _e13611 = sqrt(select(0f, _e13608, (_e13608 > 0f)));
let _e13612 = (1f / _e13611);
let _e13613 = (_e13590 * _e13612);
let _e13614 = (_e13591 * _e13612);
let _e13615 = (_e13592 * _e13612);
let _e13616 = (_e593 - _e13601);
let _e13617 = (_e605 - _e13602);
let _e13618 = (_e618 - _e13603);
let _e13623 = (((_e13616 * _e13613) + (_e13617 * _e13614)) + (_e13618 * _e13615));
let _e13628 = (((_e13616 * _e631) + (_e13617 * _e644)) + (_e13618 * _e657));
let _e13633 = (((_e13613 * _e631) + (_e13614 * _e644)) + (_e13615 * _e657));
let _e13636 = ((_e13614 * _e657) - (_e13615 * _e644));
let _e13639 = ((_e13615 * _e631) - (_e13613 * _e657));
let _e13642 = ((_e13613 * _e644) - (_e13614 * _e631));
let _e13647 = (((_e13636 * _e13636) + (_e13639 * _e13639)) + (_e13642 * _e13642));
let _e13650 = (1f / select(1e-9f, _e13647, (_e13647 > 1e-9f)));
let _e13653 = ((_e13623 - (_e13633 * _e13628)) * _e13650);
let _e13656 = (((_e13633 * _e13623) - _e13628) * _e13650);
let _e13662 = -(_e13633);
let _e13665 = global_1.member.member_13.member_2;
let _e13666 = (_e13665 * _e13665);
let _e13670 = ((1f + _e13666) - ((2f * _e13665) * _e13662));
let _e13672 = select(1e-9f, _e13670, (_e13670 > 1e-9f));
let _e13684 = global_1.member.member_13.member_3;
if (_e13684 == 2u) {
let _e13689 = (0.5f - (0.5f * _e13662));
let _e13691 = select(0f, _e13689, (_e13689 > 0f));
let _e13695 = (sqrt(select(0f, _e13691, (_e13691 > 0f))) * 255f);
let _e13696 = (255f - 1f);
let _e13698 = select(0f, _e13695, (_e13695 > 0f));
let _e13700 = select(_e13696, _e13698, (_e13698 < _e13696));
let _e13707 = select(0i, select(select(i32(_e13700), i32(-2147483648), (_e13700 < -2147483600f)), 2147483647i, (_e13700 > 2147483500f)), (_e13700 == _e13700));
let _e13711 = (_e13707 - select(0i, 1i, (_e13700 < f32(_e13707))));
let _e13714 = global_1.member.member_13.member_11;
let _e13715 = bitcast<i32>(_e13714);
let _e13716 = (_e13715 + _e13711);
let _e13718 = (bitcast<i32>(_e283) - 1i);
let _e13720 = select(_e13718, _e13716, (_e13716 < _e13718));
let _e13725 = global_2.member[bitcast<u32>(select(0i, _e13720, (_e13720 > 0i)))];
let _e13727 = (_e13715 + (_e13711 + 1i));
let _e13729 = select(_e13718, _e13727, (_e13727 < _e13718));
let _e13734 = global_2.member[bitcast<u32>(select(0i, _e13729, (_e13729 > 0i)))];
phi_38885_ = (_e13725 + ((_e13734 - _e13725) * (_e13695 - f32(_e13711))));
} else {
phi_38885_ = select(((1f - _e13666) / (_e13672 * sqrt(select(0f, _e13672, (_e13672 > 0f))))), (0.75f * (1f + (_e13662 * _e13662))), (_e13684 == 1u));
}
let _e13741 = phi_38885_;
let _e13753 = global_1.member.member_13.member_7;
let _e13754 = bitcast<i32>(_e13753);
let _e13757 = global_1.member.member_13.member_8;
let _e13758 = bitcast<i32>(_e13757);
let _e13761 = global_1.member.member_13.member_9;
let _e13762 = bitcast<i32>(_e13761);
let _e13765 = global_1.member.member_13.member_4;
let _e13771 = global_1.member.member_13.member_5;
let _e13775 = f32(_e13754);
let _e13780 = (((((_e13601 + (_e13613 * _e13653)) - _e13765.member) / (_e13771.member - _e13765.member)) * _e13775) - 0.5f);
let _e13781 = (_e13775 - 1f);
let _e13783 = select(0f, _e13780, (_e13780 > 0f));
let _e13785 = select(_e13781, _e13783, (_e13783 < _e13781));
let _e13786 = f32(_e13758);
let _e13791 = (((((_e13602 + (_e13614 * _e13653)) - _e13765.member_1) / (_e13771.member_1 - _e13765.member_1)) * _e13786) - 0.5f);
let _e13792 = (_e13786 - 1f);
let _e13794 = select(0f, _e13791, (_e13791 > 0f));
let _e13796 = select(_e13792, _e13794, (_e13794 < _e13792));
let _e13797 = f32(_e13762);
let _e13802 = (((((_e13603 + (_e13615 * _e13653)) - _e13765.member_2) / (_e13771.member_2 - _e13765.member_2)) * _e13797) - 0.5f);
let _e13803 = (_e13797 - 1f);
let _e13805 = select(0f, _e13802, (_e13802 > 0f));
let _e13807 = select(_e13803, _e13805, (_e13805 < _e13803));
let _e13809 = select(0f, _e13785, (_e13785 > 0f));
let _e13811 = select(1e6f, _e13809, (_e13809 < 1e6f));
let _e13818 = select(0i, select(select(i32(_e13811), i32(-2147483648), (_e13811 < -2147483600f)), 2147483647i, (_e13811 > 2147483500f)), (_e13811 == _e13811));
let _e13822 = (_e13818 - select(0i, 1i, (_e13811 < f32(_e13818))));
let _e13824 = select(0f, _e13796, (_e13796 > 0f));
let _e13826 = select(1e6f, _e13824, (_e13824 < 1e6f));
let _e13833 = select(0i, select(select(i32(_e13826), i32(-2147483648), (_e13826 < -2147483600f)), 2147483647i, (_e13826 > 2147483500f)), (_e13826 == _e13826));
let _e13837 = (_e13833 - select(0i, 1i, (_e13826 < f32(_e13833))));
let _e13839 = select(0f, _e13807, (_e13807 > 0f));
let _e13841 = select(1e6f, _e13839, (_e13839 < 1e6f));
let _e13848 = select(0i, select(select(i32(_e13841), i32(-2147483648), (_e13841 < -2147483600f)), 2147483647i, (_e13841 > 2147483500f)), (_e13841 == _e13841));
let _e13852 = (_e13848 - select(0i, 1i, (_e13841 < f32(_e13848))));
let _e13856 = (_e13796 - f32(_e13837));
let _e13858 = (_e13807 - f32(_e13852));
local_110 = (_e13785 - f32(_e13822));
let _e13859 = (_e13822 + 1i);
let _e13861 = select(_e13859, 0i, (_e13859 < 0i));
if (_e13861 >= _e13754) {
phi_39017_ = (_e13754 - 1i);
} else {
phi_39017_ = _e13861;
}
let _e13865 = phi_39017_;
local_111 = (_e13865 - _e13822);
let _e13867 = (_e13837 + 1i);
let _e13869 = select(_e13867, 0i, (_e13867 < 0i));
if (_e13869 >= _e13758) {
phi_39030_ = (_e13758 - 1i);
} else {
phi_39030_ = _e13869;
}
let _e13873 = phi_39030_;
let _e13875 = ((_e13873 - _e13837) * _e13754);
let _e13876 = (_e13852 + 1i);
let _e13878 = select(_e13876, 0i, (_e13876 < 0i));
if (_e13878 >= _e13762) {
phi_39044_ = (_e13762 - 1i);
} else {
phi_39044_ = _e13878;
}
let _e13882 = phi_39044_;
let _e13888 = global_1.member.member_13.member_10;
let _e13894 = ((bitcast<i32>(_e13888) + (((_e13852 * _e13758) + _e13837) * _e13754)) + _e13822);
let _e13896 = (bitcast<i32>(_e283) - 1i);
let _e13898 = select(_e13896, _e13894, (_e13894 < _e13896));
let _e13903 = global_2.member[bitcast<u32>(select(0i, _e13898, (_e13898 > 0i)))];
let _e13904 = local_110;
let _e13907 = local_111;
let _e13908 = (_e13894 + _e13907);
let _e13910 = select(_e13896, _e13908, (_e13908 < _e13896));
let _e13915 = global_2.member[bitcast<u32>(select(0i, _e13910, (_e13910 > 0i)))];
let _e13916 = local_110;
let _e13919 = (1f - _e13856);
let _e13921 = (_e13894 + _e13875);
let _e13923 = select(_e13896, _e13921, (_e13921 < _e13896));
let _e13928 = global_2.member[bitcast<u32>(select(0i, _e13923, (_e13923 > 0i)))];
let _e13929 = local_110;
let _e13932 = local_111;
let _e13933 = (_e13921 + _e13932);
let _e13935 = select(_e13896, _e13933, (_e13933 < _e13896));
let _e13940 = global_2.member[bitcast<u32>(select(0i, _e13935, (_e13935 > 0i)))];
let _e13941 = local_110;
let _e13946 = (_e13894 + (((_e13882 - _e13852) * _e13754) * _e13758));
let _e13948 = select(_e13896, _e13946, (_e13946 < _e13896));
let _e13953 = global_2.member[bitcast<u32>(select(0i, _e13948, (_e13948 > 0i)))];
let _e13954 = local_110;
let _e13957 = local_111;
let _e13958 = (_e13946 + _e13957);
let _e13960 = select(_e13896, _e13958, (_e13958 < _e13896));
let _e13965 = global_2.member[bitcast<u32>(select(0i, _e13960, (_e13960 > 0i)))];
let _e13966 = local_110;
let _e13970 = (_e13946 + _e13875);
let _e13972 = select(_e13896, _e13970, (_e13970 < _e13896));
let _e13977 = global_2.member[bitcast<u32>(select(0i, _e13972, (_e13972 > 0i)))];
let _e13978 = local_110;
let _e13981 = local_111;
let _e13982 = (_e13970 + _e13981);
let _e13984 = select(_e13896, _e13982, (_e13982 < _e13896));
let _e13989 = global_2.member[bitcast<u32>(select(0i, _e13984, (_e13984 > 0i)))];
let _e13990 = local_110;
let _e13999 = ((_e13611 * (_e13741 * (0.25f / 3.1415927f))) * ((((((_e13903 * (1f - _e13904)) + (_e13915 * _e13916)) * _e13919) + (((_e13928 * (1f - _e13929)) + (_e13940 * _e13941)) * _e13856)) * (1f - _e13858)) + (((((_e13953 * (1f - _e13954)) + (_e13965 * _e13966)) * _e13919) + (((_e13977 * (1f - _e13978)) + (_e13989 * _e13990)) * _e13856)) * _e13858)));
let _e14002 = global_1.member.member_12.member_12;
let _e14005 = global_1.member.member_12.member_4;
let _e14008 = global_1.member.member_12.member_13;
let _e14014 = global_1.member.member.member;
let _e14016 = (_e13656 / _e709);
local_107 = bitcast<i32>((_e14002 + (_e14005 * _e14008)));
local_108 = _e299;
local_109 = bitcast<i32>(_e14014);
let _e14019 = global_1.member.member_13.member_6;
let _e14020 = f32(_e14019);
let _e14022 = select(0f, _e14016, (_e14016 > 0f));
let _e14025 = (select(1f, _e14022, (_e14022 < 1f)) * _e14020);
let _e14026 = (_e14020 - 1f);
let _e14028 = select(0f, _e14026, (_e14026 > 0f));
let _e14030 = select(0f, _e14025, (_e14025 > 0f));
let _e14032 = select(_e14028, _e14030, (_e14030 < _e14028));
let _e14039 = select(0i, select(select(i32(_e14032), i32(-2147483648), (_e14032 < -2147483600f)), 2147483647i, (_e14032 > 2147483500f)), (_e14032 == _e14032));
let _e14043 = (_e14039 - select(0i, 1i, (_e14032 < f32(_e14039))));
if (_e14043 > 0i) {
let _e14046 = local_107;
let _e14047 = local_109;
let _e14050 = local_108;
let _e14051 = ((_e14046 + ((_e14043 - 1i) * _e14047)) + _e14050);
let _e14053 = (bitcast<i32>(_e286) - 1i);
let _e14055 = select(_e14053, _e14051, (_e14051 < _e14053));
let _e14060 = global_7.member[bitcast<u32>(select(0i, _e14055, (_e14055 > 0i)))];
phi_39348_ = _e14060;
} else {
phi_39348_ = 0f;
}
let _e14062 = phi_39348_;
let _e14063 = local_107;
let _e14064 = local_109;
let _e14067 = local_108;
let _e14068 = ((_e14063 + (_e14043 * _e14064)) + _e14067);
let _e14070 = (bitcast<i32>(_e286) - 1i);
let _e14072 = select(_e14070, _e14068, (_e14068 < _e14070));
let _e14077 = global_7.member[bitcast<u32>(select(0i, _e14072, (_e14072 > 0i)))];
let _e14084 = (_e13529 - _e13518);
let _e14087 = ((_e13653 - _e13518) / select(1e-9f, _e14084, (_e14084 > 1e-9f)));
local_104 = 0i;
local_105 = _e13538;
local_106 = _e13504;
let _e14089 = select(0f, _e14087, (_e14087 > 0f));
let _e14092 = (select(1f, _e14089, (_e14089 < 1f)) * _e14020);
let _e14094 = select(0f, _e14092, (_e14092 > 0f));
let _e14096 = select(_e14028, _e14094, (_e14094 < _e14028));
let _e14103 = select(0i, select(select(i32(_e14096), i32(-2147483648), (_e14096 < -2147483600f)), 2147483647i, (_e14096 > 2147483500f)), (_e14096 == _e14096));
let _e14107 = (_e14103 - select(0i, 1i, (_e14096 < f32(_e14103))));
if (_e14107 > 0i) {
let _e14110 = local_104;
let _e14111 = local_106;
let _e14114 = local_105;
let _e14115 = ((_e14110 + ((_e14107 - 1i) * _e14111)) + _e14114);
let _e14117 = select(_e14070, _e14115, (_e14115 < _e14070));
let _e14122 = global_7.member[bitcast<u32>(select(0i, _e14117, (_e14117 > 0i)))];
phi_39475_ = _e14122;
} else {
phi_39475_ = 0f;
}
let _e14124 = phi_39475_;
let _e14125 = local_104;
let _e14126 = local_106;
let _e14129 = local_105;
let _e14130 = ((_e14125 + (_e14107 * _e14126)) + _e14129);
let _e14132 = select(_e14070, _e14130, (_e14130 < _e14070));
let _e14137 = global_7.member[bitcast<u32>(select(0i, _e14132, (_e14132 > 0i)))];
let _e14143 = ((_e14062 + ((_e14077 - _e14062) * (_e14025 - f32(_e14043)))) + (_e14124 + ((_e14137 - _e14124) * (_e14092 - f32(_e14107)))));
let _e14146 = global_1.member.member_13.member;
let _e14151 = -((_e14146.member * _e14143));
let _e14153 = select(-87f, _e14151, (_e14151 > -87f));
let _e14155 = select(88f, _e14153, (_e14153 < 88f));
let _e14157 = ((_e14155 * 1.442695f) + 0.5f);
let _e14159 = select(-127f, _e14157, (_e14157 > -127f));
let _e14161 = select(128f, _e14159, (_e14159 < 128f));
let _e14168 = select(0i, select(select(i32(_e14161), i32(-2147483648), (_e14161 < -2147483600f)), 2147483647i, (_e14161 > 2147483500f)), (_e14161 == _e14161));
let _e14172 = (_e14168 - select(0i, 1i, (_e14161 < f32(_e14168))));
let _e14173 = f32(_e14172);
let _e14177 = ((_e14155 - (_e14173 * 0.6933594f)) - (_e14173 * -2.1219444e-4f));
let _e14199 = -((_e14146.member_1 * _e14143));
let _e14201 = select(-87f, _e14199, (_e14199 > -87f));
let _e14203 = select(88f, _e14201, (_e14201 < 88f));
let _e14205 = ((_e14203 * 1.442695f) + 0.5f);
let _e14207 = select(-127f, _e14205, (_e14205 > -127f));
let _e14209 = select(128f, _e14207, (_e14207 < 128f));
let _e14216 = select(0i, select(select(i32(_e14209), i32(-2147483648), (_e14209 < -2147483600f)), 2147483647i, (_e14209 > 2147483500f)), (_e14209 == _e14209));
let _e14220 = (_e14216 - select(0i, 1i, (_e14209 < f32(_e14216))));
let _e14221 = f32(_e14220);
let _e14225 = ((_e14203 - (_e14221 * 0.6933594f)) - (_e14221 * -2.1219444e-4f));
let _e14247 = -((_e14146.member_2 * _e14143));
let _e14249 = select(-87f, _e14247, (_e14247 > -87f));
let _e14251 = select(88f, _e14249, (_e14249 < 88f));
let _e14253 = ((_e14251 * 1.442695f) + 0.5f);
let _e14255 = select(-127f, _e14253, (_e14253 > -127f));
let _e14257 = select(128f, _e14255, (_e14255 < 128f));
let _e14264 = select(0i, select(select(i32(_e14257), i32(-2147483648), (_e14257 < -2147483600f)), 2147483647i, (_e14257 > 2147483500f)), (_e14257 == _e14257));
let _e14268 = (_e14264 - select(0i, 1i, (_e14257 < f32(_e14264))));
let _e14269 = f32(_e14268);
let _e14273 = ((_e14251 - (_e14269 * 0.6933594f)) - (_e14269 * -2.1219444e-4f));
let _e14296 = global_1.member.member_13.member_1;
let _e14309 = select(0f, _e13653, (((_e13656 >= 0f) && (_e13656 < _e709)) && (_e13653 > 0f)));
if _e471 {
phi_39763_ = type_26(_e11995, _e11994);
} else {
phi_39763_ = type_26(_e11994, _e11995);
}
let _e14313 = phi_39763_;
let _e14318 = f32((1i << bitcast<u32>(_e11983)));
let _e14319 = (1f / _e14318);
let _e14321 = ((_e13355 * _e14319) - 0.5f);
let _e14323 = ((_e13449 * _e14319) - 0.5f);
let _e14325 = select(-1f, _e14321, (_e14321 > -1f));
let _e14327 = select(1e6f, _e14325, (_e14325 < 1e6f));
let _e14334 = select(0i, select(select(i32(_e14327), i32(-2147483648), (_e14327 < -2147483600f)), 2147483647i, (_e14327 > 2147483500f)), (_e14327 == _e14327));
let _e14338 = (_e14334 - select(0i, 1i, (_e14327 < f32(_e14334))));
let _e14340 = select(-1f, _e14323, (_e14323 > -1f));
let _e14342 = select(1e6f, _e14340, (_e14340 < 1e6f));
let _e14349 = select(0i, select(select(i32(_e14342), i32(-2147483648), (_e14342 < -2147483600f)), 2147483647i, (_e14342 > 2147483500f)), (_e14342 == _e14342));
let _e14353 = (_e14349 - select(0i, 1i, (_e14342 < f32(_e14349))));
let _e14355 = (_e14321 - f32(_e14338));
let _e14357 = (_e14323 - f32(_e14353));
let _e14358 = (1f - _e14355);
let _e14359 = (1f - _e14357);
let _e14362 = select(_e14338, 0i, (_e14338 < 0i));
let _e14363 = (_e14362 >= _e14313.member);
if _e14363 {
phi_39841_ = (_e14313.member - 1i);
} else {
phi_39841_ = _e14362;
}
let _e14366 = phi_39841_;
let _e14368 = select(_e14353, 0i, (_e14353 < 0i));
let _e14369 = (_e14368 >= _e14313.member_1);
if _e14369 {
phi_39852_ = (_e14313.member_1 - 1i);
} else {
phi_39852_ = _e14368;
}
let _e14372 = phi_39852_;
let _e14376 = (((f32(_e14366) + 0.5f) * _e14318) - 0.5f);
let _e14380 = (((f32(_e14372) + 0.5f) * _e14318) - 0.5f);
if _e471 {
phi_39880_ = type_26(_e14372, _e14366);
} else {
phi_39880_ = type_26(_e14366, _e14372);
}
let _e14386 = phi_39880_;
let _e14392 = bitcast<i32>(((_e11927 + 1u) >> bitcast<u32>(1u)));
let _e14395 = global_1.member.member_18.member_6;
let _e14398 = global_1.member.member_18.member_7;
let _e14401 = global_1.member.member_18.member_8;
if _e11982 {
phi_39931_ = 0u;
} else {
if (_e784 == 1u) {
phi_39930_ = 0u;
} else {
if (_e784 == 2u) {
phi_39929_ = _e14395;
} else {
phi_39929_ = select(_e14401, _e14398, (_e784 == 3u));
}
let _e14407 = phi_39929_;
phi_39930_ = _e14407;
}
let _e14409 = phi_39930_;
phi_39931_ = _e14409;
}
let _e14411 = phi_39931_;
local_102 = (((bitcast<i32>(_e14411) + _e14386.member_1) * _e14392) + _e14386.member);
let _e14416 = local_102;
let _e14418 = (bitcast<i32>(_e280) - 1i);
let _e14420 = select(_e14418, _e14416, (_e14416 < _e14418));
let _e14425 = global_6.member[bitcast<u32>(select(0i, _e14420, (_e14420 > 0i)))];
let _e14430 = (((((select(_e14376, _e14380, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e14435 = ((1f - (((select(_e14380, _e14376, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e14442 = ((_e13560.member * _e14430) + (_e13568.member * _e14435));
let _e14443 = ((_e13560.member_1 * _e14430) + (_e13568.member_1 * _e14435));
let _e14444 = ((_e13560.member_2 * _e14430) + (_e13568.member_2 * _e14435));
let _e14448 = select((_e13583.member + _e14442), _e13583.member, _e13581);
let _e14449 = select((_e13583.member_1 + _e14443), _e13583.member_1, _e13581);
let _e14450 = select((_e13583.member_2 + _e14444), _e13583.member_2, _e13581);
let _e14461 = (((_e14448 * _e14448) + (_e14449 * _e14449)) + (_e14450 * _e14450));
let _e14465 = (1f / sqrt(select(0f, _e14461, (_e14461 > 0f))));
let _e14466 = (_e14448 * _e14465);
let _e14467 = (_e14449 * _e14465);
let _e14468 = (_e14450 * _e14465);
let _e14469 = (_e593 - select(_e13594.member, (_e13594.member + _e14442), _e13581));
let _e14470 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e14443), _e13581));
let _e14471 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e14444), _e13581));
let _e14476 = (((_e14469 * _e14466) + (_e14470 * _e14467)) + (_e14471 * _e14468));
let _e14481 = (((_e14469 * _e631) + (_e14470 * _e644)) + (_e14471 * _e657));
let _e14486 = (((_e14466 * _e631) + (_e14467 * _e644)) + (_e14468 * _e657));
let _e14489 = ((_e14467 * _e657) - (_e14468 * _e644));
let _e14492 = ((_e14468 * _e631) - (_e14466 * _e657));
let _e14495 = ((_e14466 * _e644) - (_e14467 * _e631));
let _e14500 = (((_e14489 * _e14489) + (_e14492 * _e14492)) + (_e14495 * _e14495));
let _e14503 = (1f / select(1e-9f, _e14500, (_e14500 > 1e-9f)));
let _e14506 = ((_e14476 - (_e14486 * _e14481)) * _e14503);
let _e14509 = (((_e14486 * _e14476) - _e14481) * _e14503);
let _e14515 = select(0f, _e14506, (((_e14509 >= 0f) && (_e14509 < _e709)) && (_e14506 > 0f)));
let _e14517 = (_e14366 << bitcast<u32>(_e11983));
let _e14529 = (_e14338 + 1i);
let _e14532 = select(_e14529, 0i, (_e14529 < 0i));
let _e14533 = (_e14532 >= _e14313.member);
if _e14533 {
phi_40915_ = (_e14313.member - 1i);
} else {
phi_40915_ = _e14532;
}
let _e14536 = phi_40915_;
if _e14369 {
phi_40926_ = (_e14313.member_1 - 1i);
} else {
phi_40926_ = _e14368;
}
let _e14539 = phi_40926_;
let _e14543 = (((f32(_e14536) + 0.5f) * _e14318) - 0.5f);
let _e14547 = (((f32(_e14539) + 0.5f) * _e14318) - 0.5f);
if _e471 {
phi_40954_ = type_26(_e14539, _e14536);
} else {
phi_40954_ = type_26(_e14536, _e14539);
}
let _e14553 = phi_40954_;
if _e11982 {
phi_41005_ = 0u;
} else {
if (_e784 == 1u) {
phi_41004_ = 0u;
} else {
if (_e784 == 2u) {
phi_41003_ = _e14395;
} else {
phi_41003_ = select(_e14401, _e14398, (_e784 == 3u));
}
let _e14561 = phi_41003_;
phi_41004_ = _e14561;
}
let _e14563 = phi_41004_;
phi_41005_ = _e14563;
}
let _e14565 = phi_41005_;
local_100 = (((bitcast<i32>(_e14565) + _e14553.member_1) * _e14392) + _e14553.member);
let _e14570 = local_100;
let _e14572 = select(_e14418, _e14570, (_e14570 < _e14418));
let _e14577 = global_6.member[bitcast<u32>(select(0i, _e14572, (_e14572 > 0i)))];
let _e14582 = (((((select(_e14543, _e14547, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e14587 = ((1f - (((select(_e14547, _e14543, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e14594 = ((_e13560.member * _e14582) + (_e13568.member * _e14587));
let _e14595 = ((_e13560.member_1 * _e14582) + (_e13568.member_1 * _e14587));
let _e14596 = ((_e13560.member_2 * _e14582) + (_e13568.member_2 * _e14587));
let _e14600 = select((_e13583.member + _e14594), _e13583.member, _e13581);
let _e14601 = select((_e13583.member_1 + _e14595), _e13583.member_1, _e13581);
let _e14602 = select((_e13583.member_2 + _e14596), _e13583.member_2, _e13581);
let _e14613 = (((_e14600 * _e14600) + (_e14601 * _e14601)) + (_e14602 * _e14602));
let _e14617 = (1f / sqrt(select(0f, _e14613, (_e14613 > 0f))));
let _e14618 = (_e14600 * _e14617);
let _e14619 = (_e14601 * _e14617);
let _e14620 = (_e14602 * _e14617);
let _e14621 = (_e593 - select(_e13594.member, (_e13594.member + _e14594), _e13581));
let _e14622 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e14595), _e13581));
let _e14623 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e14596), _e13581));
let _e14628 = (((_e14621 * _e14618) + (_e14622 * _e14619)) + (_e14623 * _e14620));
let _e14633 = (((_e14621 * _e631) + (_e14622 * _e644)) + (_e14623 * _e657));
let _e14638 = (((_e14618 * _e631) + (_e14619 * _e644)) + (_e14620 * _e657));
let _e14641 = ((_e14619 * _e657) - (_e14620 * _e644));
let _e14644 = ((_e14620 * _e631) - (_e14618 * _e657));
let _e14647 = ((_e14618 * _e644) - (_e14619 * _e631));
let _e14652 = (((_e14641 * _e14641) + (_e14644 * _e14644)) + (_e14647 * _e14647));
let _e14655 = (1f / select(1e-9f, _e14652, (_e14652 > 1e-9f)));
let _e14658 = ((_e14628 - (_e14638 * _e14633)) * _e14655);
let _e14661 = (((_e14638 * _e14628) - _e14633) * _e14655);
let _e14667 = select(0f, _e14658, (((_e14661 >= 0f) && (_e14661 < _e709)) && (_e14658 > 0f)));
let _e14669 = (_e14536 << bitcast<u32>(_e11983));
let _e14681 = (_e14353 + 1i);
if _e14363 {
phi_41989_ = (_e14313.member - 1i);
} else {
phi_41989_ = _e14362;
}
let _e14685 = phi_41989_;
let _e14687 = select(_e14681, 0i, (_e14681 < 0i));
let _e14688 = (_e14687 >= _e14313.member_1);
if _e14688 {
phi_42000_ = (_e14313.member_1 - 1i);
} else {
phi_42000_ = _e14687;
}
let _e14691 = phi_42000_;
let _e14695 = (((f32(_e14685) + 0.5f) * _e14318) - 0.5f);
let _e14699 = (((f32(_e14691) + 0.5f) * _e14318) - 0.5f);
if _e471 {
phi_42028_ = type_26(_e14691, _e14685);
} else {
phi_42028_ = type_26(_e14685, _e14691);
}
let _e14705 = phi_42028_;
if _e11982 {
phi_42079_ = 0u;
} else {
if (_e784 == 1u) {
phi_42078_ = 0u;
} else {
if (_e784 == 2u) {
phi_42077_ = _e14395;
} else {
phi_42077_ = select(_e14401, _e14398, (_e784 == 3u));
}
let _e14713 = phi_42077_;
phi_42078_ = _e14713;
}
let _e14715 = phi_42078_;
phi_42079_ = _e14715;
}
let _e14717 = phi_42079_;
local_98 = (((bitcast<i32>(_e14717) + _e14705.member_1) * _e14392) + _e14705.member);
let _e14722 = local_98;
let _e14724 = select(_e14418, _e14722, (_e14722 < _e14418));
let _e14729 = global_6.member[bitcast<u32>(select(0i, _e14724, (_e14724 > 0i)))];
let _e14734 = (((((select(_e14695, _e14699, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e14739 = ((1f - (((select(_e14699, _e14695, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e14746 = ((_e13560.member * _e14734) + (_e13568.member * _e14739));
let _e14747 = ((_e13560.member_1 * _e14734) + (_e13568.member_1 * _e14739));
let _e14748 = ((_e13560.member_2 * _e14734) + (_e13568.member_2 * _e14739));
let _e14752 = select((_e13583.member + _e14746), _e13583.member, _e13581);
let _e14753 = select((_e13583.member_1 + _e14747), _e13583.member_1, _e13581);
let _e14754 = select((_e13583.member_2 + _e14748), _e13583.member_2, _e13581);
let _e14765 = (((_e14752 * _e14752) + (_e14753 * _e14753)) + (_e14754 * _e14754));
let _e14769 = (1f / sqrt(select(0f, _e14765, (_e14765 > 0f))));
let _e14770 = (_e14752 * _e14769);
let _e14771 = (_e14753 * _e14769);
let _e14772 = (_e14754 * _e14769);
let _e14773 = (_e593 - select(_e13594.member, (_e13594.member + _e14746), _e13581));
let _e14774 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e14747), _e13581));
let _e14775 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e14748), _e13581));
let _e14780 = (((_e14773 * _e14770) + (_e14774 * _e14771)) + (_e14775 * _e14772));
let _e14785 = (((_e14773 * _e631) + (_e14774 * _e644)) + (_e14775 * _e657));
let _e14790 = (((_e14770 * _e631) + (_e14771 * _e644)) + (_e14772 * _e657));
let _e14793 = ((_e14771 * _e657) - (_e14772 * _e644));
let _e14796 = ((_e14772 * _e631) - (_e14770 * _e657));
let _e14799 = ((_e14770 * _e644) - (_e14771 * _e631));
let _e14804 = (((_e14793 * _e14793) + (_e14796 * _e14796)) + (_e14799 * _e14799));
let _e14807 = (1f / select(1e-9f, _e14804, (_e14804 > 1e-9f)));
let _e14810 = ((_e14780 - (_e14790 * _e14785)) * _e14807);
let _e14813 = (((_e14790 * _e14780) - _e14785) * _e14807);
let _e14819 = select(0f, _e14810, (((_e14813 >= 0f) && (_e14813 < _e709)) && (_e14810 > 0f)));
let _e14821 = (_e14685 << bitcast<u32>(_e11983));
if _e14533 {
phi_43063_ = (_e14313.member - 1i);
} else {
phi_43063_ = _e14532;
}
let _e14836 = phi_43063_;
if _e14688 {
phi_43074_ = (_e14313.member_1 - 1i);
} else {
phi_43074_ = _e14687;
}
let _e14839 = phi_43074_;
let _e14843 = (((f32(_e14836) + 0.5f) * _e14318) - 0.5f);
let _e14847 = (((f32(_e14839) + 0.5f) * _e14318) - 0.5f);
if _e471 {
phi_43102_ = type_26(_e14839, _e14836);
} else {
phi_43102_ = type_26(_e14836, _e14839);
}
let _e14853 = phi_43102_;
if _e11982 {
phi_43153_ = 0u;
} else {
if (_e784 == 1u) {
phi_43152_ = 0u;
} else {
if (_e784 == 2u) {
phi_43151_ = _e14395;
} else {
phi_43151_ = select(_e14401, _e14398, (_e784 == 3u));
}
let _e14861 = phi_43151_;
phi_43152_ = _e14861;
}
let _e14863 = phi_43152_;
phi_43153_ = _e14863;
}
let _e14865 = phi_43153_;
local_96 = (((bitcast<i32>(_e14865) + _e14853.member_1) * _e14392) + _e14853.member);
let _e14870 = local_96;
let _e14872 = select(_e14418, _e14870, (_e14870 < _e14418));
let _e14877 = global_6.member[bitcast<u32>(select(0i, _e14872, (_e14872 > 0i)))];
let _e14882 = (((((select(_e14843, _e14847, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e14887 = ((1f - (((select(_e14847, _e14843, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e14894 = ((_e13560.member * _e14882) + (_e13568.member * _e14887));
let _e14895 = ((_e13560.member_1 * _e14882) + (_e13568.member_1 * _e14887));
let _e14896 = ((_e13560.member_2 * _e14882) + (_e13568.member_2 * _e14887));
let _e14900 = select((_e13583.member + _e14894), _e13583.member, _e13581);
let _e14901 = select((_e13583.member_1 + _e14895), _e13583.member_1, _e13581);
let _e14902 = select((_e13583.member_2 + _e14896), _e13583.member_2, _e13581);
let _e14913 = (((_e14900 * _e14900) + (_e14901 * _e14901)) + (_e14902 * _e14902));
let _e14917 = (1f / sqrt(select(0f, _e14913, (_e14913 > 0f))));
let _e14918 = (_e14900 * _e14917);
let _e14919 = (_e14901 * _e14917);
let _e14920 = (_e14902 * _e14917);
let _e14921 = (_e593 - select(_e13594.member, (_e13594.member + _e14894), _e13581));
let _e14922 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e14895), _e13581));
let _e14923 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e14896), _e13581));
let _e14928 = (((_e14921 * _e14918) + (_e14922 * _e14919)) + (_e14923 * _e14920));
let _e14933 = (((_e14921 * _e631) + (_e14922 * _e644)) + (_e14923 * _e657));
let _e14938 = (((_e14918 * _e631) + (_e14919 * _e644)) + (_e14920 * _e657));
let _e14941 = ((_e14919 * _e657) - (_e14920 * _e644));
let _e14944 = ((_e14920 * _e631) - (_e14918 * _e657));
let _e14947 = ((_e14918 * _e644) - (_e14919 * _e631));
let _e14952 = (((_e14941 * _e14941) + (_e14944 * _e14944)) + (_e14947 * _e14947));
let _e14955 = (1f / select(1e-9f, _e14952, (_e14952 > 1e-9f)));
let _e14958 = ((_e14928 - (_e14938 * _e14933)) * _e14955);
let _e14961 = (((_e14938 * _e14928) - _e14933) * _e14955);
let _e14967 = select(0f, _e14958, (((_e14961 >= 0f) && (_e14961 < _e709)) && (_e14958 > 0f)));
let _e14969 = (_e14836 << bitcast<u32>(_e11983));
let _e14981 = select(((((1f - select(0f, (_e14358 * _e14359), (((select(select(_e784, _e941, (_e14517 >= _e710)), _e863, (_e14517 < _e316)) == _e784) && (_e14515 > 0f)) && (_e14515 < _e14425)))) - select(0f, (_e14355 * _e14359), (((select(select(_e784, _e941, (_e14669 >= _e710)), _e863, (_e14669 < _e316)) == _e784) && (_e14667 > 0f)) && (_e14667 < _e14577)))) - select(0f, (_e14358 * _e14357), (((select(select(_e784, _e941, (_e14821 >= _e710)), _e863, (_e14821 < _e316)) == _e784) && (_e14819 > 0f)) && (_e14819 < _e14729)))) - select(0f, (_e14355 * _e14357), (((select(select(_e784, _e941, (_e14969 >= _e710)), _e863, (_e14969 < _e316)) == _e784) && (_e14967 > 0f)) && (_e14967 < _e14877)))), 1f, _e11982);
let _e14982 = (_e13334 & 31u);
let _e14984 = (1u << bitcast<u32>(_e14982));
let _e14993 = bitcast<i32>((((_e11927 + _e14984) - 1u) >> bitcast<u32>(_e14982)));
let _e14994 = bitcast<i32>((((_e11930 + _e14984) - 1u) >> bitcast<u32>(_e14982)));
if _e471 {
phi_44155_ = type_26(_e14994, _e14993);
} else {
phi_44155_ = type_26(_e14993, _e14994);
}
let _e14998 = phi_44155_;
let _e15003 = f32((1i << bitcast<u32>(_e14982)));
let _e15004 = (1f / _e15003);
let _e15006 = ((_e13355 * _e15004) - 0.5f);
let _e15008 = ((_e13449 * _e15004) - 0.5f);
let _e15010 = select(-1f, _e15006, (_e15006 > -1f));
let _e15012 = select(1e6f, _e15010, (_e15010 < 1e6f));
let _e15019 = select(0i, select(select(i32(_e15012), i32(-2147483648), (_e15012 < -2147483600f)), 2147483647i, (_e15012 > 2147483500f)), (_e15012 == _e15012));
let _e15023 = (_e15019 - select(0i, 1i, (_e15012 < f32(_e15019))));
let _e15025 = select(-1f, _e15008, (_e15008 > -1f));
let _e15027 = select(1e6f, _e15025, (_e15025 < 1e6f));
let _e15034 = select(0i, select(select(i32(_e15027), i32(-2147483648), (_e15027 < -2147483600f)), 2147483647i, (_e15027 > 2147483500f)), (_e15027 == _e15027));
let _e15038 = (_e15034 - select(0i, 1i, (_e15027 < f32(_e15034))));
let _e15040 = (_e15006 - f32(_e15023));
let _e15042 = (_e15008 - f32(_e15038));
let _e15043 = (1f - _e15040);
let _e15044 = (1f - _e15042);
let _e15047 = select(_e15023, 0i, (_e15023 < 0i));
let _e15048 = (_e15047 >= _e14998.member);
if _e15048 {
phi_44233_ = (_e14998.member - 1i);
} else {
phi_44233_ = _e15047;
}
let _e15051 = phi_44233_;
let _e15053 = select(_e15038, 0i, (_e15038 < 0i));
let _e15054 = (_e15053 >= _e14998.member_1);
if _e15054 {
phi_44244_ = (_e14998.member_1 - 1i);
} else {
phi_44244_ = _e15053;
}
let _e15057 = phi_44244_;
let _e15061 = (((f32(_e15051) + 0.5f) * _e15003) - 0.5f);
let _e15065 = (((f32(_e15057) + 0.5f) * _e15003) - 0.5f);
if _e471 {
phi_44272_ = type_26(_e15057, _e15051);
} else {
phi_44272_ = type_26(_e15051, _e15057);
}
let _e15071 = phi_44272_;
let _e15074 = (_e13334 == 0u);
if _e15074 {
phi_44323_ = 0u;
} else {
if (_e13334 == 1u) {
phi_44322_ = 0u;
} else {
if (_e13334 == 2u) {
phi_44321_ = _e14395;
} else {
phi_44321_ = select(_e14401, _e14398, (_e13334 == 3u));
}
let _e15080 = phi_44321_;
phi_44322_ = _e15080;
}
let _e15082 = phi_44322_;
phi_44323_ = _e15082;
}
let _e15084 = phi_44323_;
local_94 = (((bitcast<i32>(_e15084) + _e15071.member_1) * _e14392) + _e15071.member);
let _e15089 = local_94;
let _e15091 = select(_e14418, _e15089, (_e15089 < _e14418));
let _e15096 = global_6.member[bitcast<u32>(select(0i, _e15091, (_e15091 > 0i)))];
let _e15101 = (((((select(_e15061, _e15065, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e15106 = ((1f - (((select(_e15065, _e15061, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e15113 = ((_e13560.member * _e15101) + (_e13568.member * _e15106));
let _e15114 = ((_e13560.member_1 * _e15101) + (_e13568.member_1 * _e15106));
let _e15115 = ((_e13560.member_2 * _e15101) + (_e13568.member_2 * _e15106));
let _e15119 = select((_e13583.member + _e15113), _e13583.member, _e13581);
let _e15120 = select((_e13583.member_1 + _e15114), _e13583.member_1, _e13581);
let _e15121 = select((_e13583.member_2 + _e15115), _e13583.member_2, _e13581);
let _e15132 = (((_e15119 * _e15119) + (_e15120 * _e15120)) + (_e15121 * _e15121));
let _e15136 = (1f / sqrt(select(0f, _e15132, (_e15132 > 0f))));
let _e15137 = (_e15119 * _e15136);
let _e15138 = (_e15120 * _e15136);
let _e15139 = (_e15121 * _e15136);
let _e15140 = (_e593 - select(_e13594.member, (_e13594.member + _e15113), _e13581));
let _e15141 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e15114), _e13581));
let _e15142 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e15115), _e13581));
let _e15147 = (((_e15140 * _e15137) + (_e15141 * _e15138)) + (_e15142 * _e15139));
let _e15152 = (((_e15140 * _e631) + (_e15141 * _e644)) + (_e15142 * _e657));
let _e15157 = (((_e15137 * _e631) + (_e15138 * _e644)) + (_e15139 * _e657));
let _e15160 = ((_e15138 * _e657) - (_e15139 * _e644));
let _e15163 = ((_e15139 * _e631) - (_e15137 * _e657));
let _e15166 = ((_e15137 * _e644) - (_e15138 * _e631));
let _e15171 = (((_e15160 * _e15160) + (_e15163 * _e15163)) + (_e15166 * _e15166));
let _e15174 = (1f / select(1e-9f, _e15171, (_e15171 > 1e-9f)));
let _e15177 = ((_e15147 - (_e15157 * _e15152)) * _e15174);
let _e15180 = (((_e15157 * _e15147) - _e15152) * _e15174);
let _e15186 = select(0f, _e15177, (((_e15180 >= 0f) && (_e15180 < _e709)) && (_e15177 > 0f)));
let _e15188 = (_e15051 << bitcast<u32>(_e14982));
let _e15200 = (_e15023 + 1i);
let _e15203 = select(_e15200, 0i, (_e15200 < 0i));
let _e15204 = (_e15203 >= _e14998.member);
if _e15204 {
phi_45307_ = (_e14998.member - 1i);
} else {
phi_45307_ = _e15203;
}
let _e15207 = phi_45307_;
if _e15054 {
phi_45318_ = (_e14998.member_1 - 1i);
} else {
phi_45318_ = _e15053;
}
let _e15210 = phi_45318_;
let _e15214 = (((f32(_e15207) + 0.5f) * _e15003) - 0.5f);
let _e15218 = (((f32(_e15210) + 0.5f) * _e15003) - 0.5f);
if _e471 {
phi_45346_ = type_26(_e15210, _e15207);
} else {
phi_45346_ = type_26(_e15207, _e15210);
}
let _e15224 = phi_45346_;
if _e15074 {
phi_45397_ = 0u;
} else {
if (_e13334 == 1u) {
phi_45396_ = 0u;
} else {
if (_e13334 == 2u) {
phi_45395_ = _e14395;
} else {
phi_45395_ = select(_e14401, _e14398, (_e13334 == 3u));
}
let _e15232 = phi_45395_;
phi_45396_ = _e15232;
}
let _e15234 = phi_45396_;
phi_45397_ = _e15234;
}
let _e15236 = phi_45397_;
local_92 = (((bitcast<i32>(_e15236) + _e15224.member_1) * _e14392) + _e15224.member);
let _e15241 = local_92;
let _e15243 = select(_e14418, _e15241, (_e15241 < _e14418));
let _e15248 = global_6.member[bitcast<u32>(select(0i, _e15243, (_e15243 > 0i)))];
let _e15253 = (((((select(_e15214, _e15218, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e15258 = ((1f - (((select(_e15218, _e15214, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e15265 = ((_e13560.member * _e15253) + (_e13568.member * _e15258));
let _e15266 = ((_e13560.member_1 * _e15253) + (_e13568.member_1 * _e15258));
let _e15267 = ((_e13560.member_2 * _e15253) + (_e13568.member_2 * _e15258));
let _e15271 = select((_e13583.member + _e15265), _e13583.member, _e13581);
let _e15272 = select((_e13583.member_1 + _e15266), _e13583.member_1, _e13581);
let _e15273 = select((_e13583.member_2 + _e15267), _e13583.member_2, _e13581);
let _e15284 = (((_e15271 * _e15271) + (_e15272 * _e15272)) + (_e15273 * _e15273));
let _e15288 = (1f / sqrt(select(0f, _e15284, (_e15284 > 0f))));
let _e15289 = (_e15271 * _e15288);
let _e15290 = (_e15272 * _e15288);
let _e15291 = (_e15273 * _e15288);
let _e15292 = (_e593 - select(_e13594.member, (_e13594.member + _e15265), _e13581));
let _e15293 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e15266), _e13581));
let _e15294 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e15267), _e13581));
let _e15299 = (((_e15292 * _e15289) + (_e15293 * _e15290)) + (_e15294 * _e15291));
let _e15304 = (((_e15292 * _e631) + (_e15293 * _e644)) + (_e15294 * _e657));
let _e15309 = (((_e15289 * _e631) + (_e15290 * _e644)) + (_e15291 * _e657));
let _e15312 = ((_e15290 * _e657) - (_e15291 * _e644));
let _e15315 = ((_e15291 * _e631) - (_e15289 * _e657));
let _e15318 = ((_e15289 * _e644) - (_e15290 * _e631));
let _e15323 = (((_e15312 * _e15312) + (_e15315 * _e15315)) + (_e15318 * _e15318));
let _e15326 = (1f / select(1e-9f, _e15323, (_e15323 > 1e-9f)));
let _e15329 = ((_e15299 - (_e15309 * _e15304)) * _e15326);
let _e15332 = (((_e15309 * _e15299) - _e15304) * _e15326);
let _e15338 = select(0f, _e15329, (((_e15332 >= 0f) && (_e15332 < _e709)) && (_e15329 > 0f)));
let _e15340 = (_e15207 << bitcast<u32>(_e14982));
let _e15352 = (_e15038 + 1i);
if _e15048 {
phi_46381_ = (_e14998.member - 1i);
} else {
phi_46381_ = _e15047;
}
let _e15356 = phi_46381_;
let _e15358 = select(_e15352, 0i, (_e15352 < 0i));
let _e15359 = (_e15358 >= _e14998.member_1);
if _e15359 {
phi_46392_ = (_e14998.member_1 - 1i);
} else {
phi_46392_ = _e15358;
}
let _e15362 = phi_46392_;
let _e15366 = (((f32(_e15356) + 0.5f) * _e15003) - 0.5f);
let _e15370 = (((f32(_e15362) + 0.5f) * _e15003) - 0.5f);
if _e471 {
phi_46420_ = type_26(_e15362, _e15356);
} else {
phi_46420_ = type_26(_e15356, _e15362);
}
let _e15376 = phi_46420_;
if _e15074 {
phi_46471_ = 0u;
} else {
if (_e13334 == 1u) {
phi_46470_ = 0u;
} else {
if (_e13334 == 2u) {
phi_46469_ = _e14395;
} else {
phi_46469_ = select(_e14401, _e14398, (_e13334 == 3u));
}
let _e15384 = phi_46469_;
phi_46470_ = _e15384;
}
let _e15386 = phi_46470_;
phi_46471_ = _e15386;
}
let _e15388 = phi_46471_;
local_90 = (((bitcast<i32>(_e15388) + _e15376.member_1) * _e14392) + _e15376.member);
let _e15393 = local_90;
let _e15395 = select(_e14418, _e15393, (_e15393 < _e14418));
let _e15400 = global_6.member[bitcast<u32>(select(0i, _e15395, (_e15395 > 0i)))];
let _e15405 = (((((select(_e15366, _e15370, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e15410 = ((1f - (((select(_e15370, _e15366, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e15417 = ((_e13560.member * _e15405) + (_e13568.member * _e15410));
let _e15418 = ((_e13560.member_1 * _e15405) + (_e13568.member_1 * _e15410));
let _e15419 = ((_e13560.member_2 * _e15405) + (_e13568.member_2 * _e15410));
let _e15423 = select((_e13583.member + _e15417), _e13583.member, _e13581);
let _e15424 = select((_e13583.member_1 + _e15418), _e13583.member_1, _e13581);
let _e15425 = select((_e13583.member_2 + _e15419), _e13583.member_2, _e13581);
let _e15436 = (((_e15423 * _e15423) + (_e15424 * _e15424)) + (_e15425 * _e15425));
let _e15440 = (1f / sqrt(select(0f, _e15436, (_e15436 > 0f))));
let _e15441 = (_e15423 * _e15440);
let _e15442 = (_e15424 * _e15440);
let _e15443 = (_e15425 * _e15440);
let _e15444 = (_e593 - select(_e13594.member, (_e13594.member + _e15417), _e13581));
let _e15445 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e15418), _e13581));
let _e15446 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e15419), _e13581));
let _e15451 = (((_e15444 * _e15441) + (_e15445 * _e15442)) + (_e15446 * _e15443));
let _e15456 = (((_e15444 * _e631) + (_e15445 * _e644)) + (_e15446 * _e657));
let _e15461 = (((_e15441 * _e631) + (_e15442 * _e644)) + (_e15443 * _e657));
let _e15464 = ((_e15442 * _e657) - (_e15443 * _e644));
let _e15467 = ((_e15443 * _e631) - (_e15441 * _e657));
let _e15470 = ((_e15441 * _e644) - (_e15442 * _e631));
let _e15475 = (((_e15464 * _e15464) + (_e15467 * _e15467)) + (_e15470 * _e15470));
let _e15478 = (1f / select(1e-9f, _e15475, (_e15475 > 1e-9f)));
let _e15481 = ((_e15451 - (_e15461 * _e15456)) * _e15478);
let _e15484 = (((_e15461 * _e15451) - _e15456) * _e15478);
let _e15490 = select(0f, _e15481, (((_e15484 >= 0f) && (_e15484 < _e709)) && (_e15481 > 0f)));
let _e15492 = (_e15356 << bitcast<u32>(_e14982));
if _e15204 {
phi_47455_ = (_e14998.member - 1i);
} else {
phi_47455_ = _e15203;
}
let _e15507 = phi_47455_;
if _e15359 {
phi_47466_ = (_e14998.member_1 - 1i);
} else {
phi_47466_ = _e15358;
}
let _e15510 = phi_47466_;
let _e15514 = (((f32(_e15507) + 0.5f) * _e15003) - 0.5f);
let _e15518 = (((f32(_e15510) + 0.5f) * _e15003) - 0.5f);
if _e471 {
phi_47494_ = type_26(_e15510, _e15507);
} else {
phi_47494_ = type_26(_e15507, _e15510);
}
let _e15524 = phi_47494_;
if _e15074 {
phi_47545_ = 0u;
} else {
if (_e13334 == 1u) {
phi_47544_ = 0u;
} else {
if (_e13334 == 2u) {
phi_47543_ = _e14395;
} else {
phi_47543_ = select(_e14401, _e14398, (_e13334 == 3u));
}
let _e15532 = phi_47543_;
phi_47544_ = _e15532;
}
let _e15534 = phi_47544_;
phi_47545_ = _e15534;
}
let _e15536 = phi_47545_;
local_88 = (((bitcast<i32>(_e15536) + _e15524.member_1) * _e14392) + _e15524.member);
let _e15541 = local_88;
let _e15543 = select(_e14418, _e15541, (_e15541 < _e14418));
let _e15548 = global_6.member[bitcast<u32>(select(0i, _e15543, (_e15543 > 0i)))];
let _e15553 = (((((select(_e15514, _e15518, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e15558 = ((1f - (((select(_e15518, _e15514, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e15565 = ((_e13560.member * _e15553) + (_e13568.member * _e15558));
let _e15566 = ((_e13560.member_1 * _e15553) + (_e13568.member_1 * _e15558));
let _e15567 = ((_e13560.member_2 * _e15553) + (_e13568.member_2 * _e15558));
let _e15571 = select((_e13583.member + _e15565), _e13583.member, _e13581);
let _e15572 = select((_e13583.member_1 + _e15566), _e13583.member_1, _e13581);
let _e15573 = select((_e13583.member_2 + _e15567), _e13583.member_2, _e13581);
let _e15584 = (((_e15571 * _e15571) + (_e15572 * _e15572)) + (_e15573 * _e15573));
let _e15588 = (1f / sqrt(select(0f, _e15584, (_e15584 > 0f))));
let _e15589 = (_e15571 * _e15588);
let _e15590 = (_e15572 * _e15588);
let _e15591 = (_e15573 * _e15588);
let _e15592 = (_e593 - select(_e13594.member, (_e13594.member + _e15565), _e13581));
let _e15593 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e15566), _e13581));
let _e15594 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e15567), _e13581));
let _e15599 = (((_e15592 * _e15589) + (_e15593 * _e15590)) + (_e15594 * _e15591));
let _e15604 = (((_e15592 * _e631) + (_e15593 * _e644)) + (_e15594 * _e657));
let _e15609 = (((_e15589 * _e631) + (_e15590 * _e644)) + (_e15591 * _e657));
let _e15612 = ((_e15590 * _e657) - (_e15591 * _e644));
let _e15615 = ((_e15591 * _e631) - (_e15589 * _e657));
let _e15618 = ((_e15589 * _e644) - (_e15590 * _e631));
let _e15623 = (((_e15612 * _e15612) + (_e15615 * _e15615)) + (_e15618 * _e15618));
let _e15626 = (1f / select(1e-9f, _e15623, (_e15623 > 1e-9f)));
let _e15629 = ((_e15599 - (_e15609 * _e15604)) * _e15626);
let _e15632 = (((_e15609 * _e15599) - _e15604) * _e15626);
let _e15638 = select(0f, _e15629, (((_e15632 >= 0f) && (_e15632 < _e709)) && (_e15629 > 0f)));
let _e15640 = (_e15507 << bitcast<u32>(_e14982));
let _e15652 = select(((((_e14981 - select(0f, (_e15043 * _e15044), (((select(select(_e784, _e941, (_e15188 >= _e710)), _e863, (_e15188 < _e316)) == _e13334) && (_e15186 > 0f)) && (_e15186 < _e15096)))) - select(0f, (_e15040 * _e15044), (((select(select(_e784, _e941, (_e15340 >= _e710)), _e863, (_e15340 < _e316)) == _e13334) && (_e15338 > 0f)) && (_e15338 < _e15248)))) - select(0f, (_e15043 * _e15042), (((select(select(_e784, _e941, (_e15492 >= _e710)), _e863, (_e15492 < _e316)) == _e13334) && (_e15490 > 0f)) && (_e15490 < _e15400)))) - select(0f, (_e15040 * _e15042), (((select(select(_e784, _e941, (_e15640 >= _e710)), _e863, (_e15640 < _e316)) == _e13334) && (_e15638 > 0f)) && (_e15638 < _e15548)))), _e14981, _e15074);
let _e15653 = (_e13338 & 31u);
let _e15655 = (1u << bitcast<u32>(_e15653));
let _e15664 = bitcast<i32>((((_e11927 + _e15655) - 1u) >> bitcast<u32>(_e15653)));
let _e15665 = bitcast<i32>((((_e11930 + _e15655) - 1u) >> bitcast<u32>(_e15653)));
if _e471 {
phi_48547_ = type_26(_e15665, _e15664);
} else {
phi_48547_ = type_26(_e15664, _e15665);
}
let _e15669 = phi_48547_;
let _e15674 = f32((1i << bitcast<u32>(_e15653)));
let _e15675 = (1f / _e15674);
let _e15677 = ((_e13355 * _e15675) - 0.5f);
let _e15679 = ((_e13449 * _e15675) - 0.5f);
let _e15681 = select(-1f, _e15677, (_e15677 > -1f));
let _e15683 = select(1e6f, _e15681, (_e15681 < 1e6f));
let _e15690 = select(0i, select(select(i32(_e15683), i32(-2147483648), (_e15683 < -2147483600f)), 2147483647i, (_e15683 > 2147483500f)), (_e15683 == _e15683));
let _e15694 = (_e15690 - select(0i, 1i, (_e15683 < f32(_e15690))));
let _e15696 = select(-1f, _e15679, (_e15679 > -1f));
let _e15698 = select(1e6f, _e15696, (_e15696 < 1e6f));
let _e15705 = select(0i, select(select(i32(_e15698), i32(-2147483648), (_e15698 < -2147483600f)), 2147483647i, (_e15698 > 2147483500f)), (_e15698 == _e15698));
let _e15709 = (_e15705 - select(0i, 1i, (_e15698 < f32(_e15705))));
let _e15711 = (_e15677 - f32(_e15694));
let _e15713 = (_e15679 - f32(_e15709));
let _e15714 = (1f - _e15711);
let _e15715 = (1f - _e15713);
let _e15718 = select(_e15694, 0i, (_e15694 < 0i));
let _e15719 = (_e15718 >= _e15669.member);
if _e15719 {
phi_48625_ = (_e15669.member - 1i);
} else {
phi_48625_ = _e15718;
}
let _e15722 = phi_48625_;
let _e15724 = select(_e15709, 0i, (_e15709 < 0i));
let _e15725 = (_e15724 >= _e15669.member_1);
if _e15725 {
phi_48636_ = (_e15669.member_1 - 1i);
} else {
phi_48636_ = _e15724;
}
let _e15728 = phi_48636_;
let _e15732 = (((f32(_e15722) + 0.5f) * _e15674) - 0.5f);
let _e15736 = (((f32(_e15728) + 0.5f) * _e15674) - 0.5f);
if _e471 {
phi_48664_ = type_26(_e15728, _e15722);
} else {
phi_48664_ = type_26(_e15722, _e15728);
}
let _e15742 = phi_48664_;
let _e15745 = (_e13338 == 0u);
if _e15745 {
phi_48715_ = 0u;
} else {
if (_e13338 == 1u) {
phi_48714_ = 0u;
} else {
if (_e13338 == 2u) {
phi_48713_ = _e14395;
} else {
phi_48713_ = select(_e14401, _e14398, (_e13338 == 3u));
}
let _e15751 = phi_48713_;
phi_48714_ = _e15751;
}
let _e15753 = phi_48714_;
phi_48715_ = _e15753;
}
let _e15755 = phi_48715_;
local_86 = (((bitcast<i32>(_e15755) + _e15742.member_1) * _e14392) + _e15742.member);
let _e15760 = local_86;
let _e15762 = select(_e14418, _e15760, (_e15760 < _e14418));
let _e15767 = global_6.member[bitcast<u32>(select(0i, _e15762, (_e15762 > 0i)))];
let _e15772 = (((((select(_e15732, _e15736, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e15777 = ((1f - (((select(_e15736, _e15732, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e15784 = ((_e13560.member * _e15772) + (_e13568.member * _e15777));
let _e15785 = ((_e13560.member_1 * _e15772) + (_e13568.member_1 * _e15777));
let _e15786 = ((_e13560.member_2 * _e15772) + (_e13568.member_2 * _e15777));
let _e15790 = select((_e13583.member + _e15784), _e13583.member, _e13581);
let _e15791 = select((_e13583.member_1 + _e15785), _e13583.member_1, _e13581);
let _e15792 = select((_e13583.member_2 + _e15786), _e13583.member_2, _e13581);
let _e15803 = (((_e15790 * _e15790) + (_e15791 * _e15791)) + (_e15792 * _e15792));
let _e15807 = (1f / sqrt(select(0f, _e15803, (_e15803 > 0f))));
let _e15808 = (_e15790 * _e15807);
let _e15809 = (_e15791 * _e15807);
let _e15810 = (_e15792 * _e15807);
let _e15811 = (_e593 - select(_e13594.member, (_e13594.member + _e15784), _e13581));
let _e15812 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e15785), _e13581));
let _e15813 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e15786), _e13581));
let _e15818 = (((_e15811 * _e15808) + (_e15812 * _e15809)) + (_e15813 * _e15810));
let _e15823 = (((_e15811 * _e631) + (_e15812 * _e644)) + (_e15813 * _e657));
let _e15828 = (((_e15808 * _e631) + (_e15809 * _e644)) + (_e15810 * _e657));
let _e15831 = ((_e15809 * _e657) - (_e15810 * _e644));
let _e15834 = ((_e15810 * _e631) - (_e15808 * _e657));
let _e15837 = ((_e15808 * _e644) - (_e15809 * _e631));
let _e15842 = (((_e15831 * _e15831) + (_e15834 * _e15834)) + (_e15837 * _e15837));
let _e15845 = (1f / select(1e-9f, _e15842, (_e15842 > 1e-9f)));
let _e15848 = ((_e15818 - (_e15828 * _e15823)) * _e15845);
let _e15851 = (((_e15828 * _e15818) - _e15823) * _e15845);
let _e15857 = select(0f, _e15848, (((_e15851 >= 0f) && (_e15851 < _e709)) && (_e15848 > 0f)));
let _e15859 = (_e15722 << bitcast<u32>(_e15653));
let _e15871 = (_e15694 + 1i);
let _e15874 = select(_e15871, 0i, (_e15871 < 0i));
let _e15875 = (_e15874 >= _e15669.member);
if _e15875 {
phi_49699_ = (_e15669.member - 1i);
} else {
phi_49699_ = _e15874;
}
let _e15878 = phi_49699_;
if _e15725 {
phi_49710_ = (_e15669.member_1 - 1i);
} else {
phi_49710_ = _e15724;
}
let _e15881 = phi_49710_;
let _e15885 = (((f32(_e15878) + 0.5f) * _e15674) - 0.5f);
let _e15889 = (((f32(_e15881) + 0.5f) * _e15674) - 0.5f);
if _e471 {
phi_49738_ = type_26(_e15881, _e15878);
} else {
phi_49738_ = type_26(_e15878, _e15881);
}
let _e15895 = phi_49738_;
if _e15745 {
phi_49789_ = 0u;
} else {
if (_e13338 == 1u) {
phi_49788_ = 0u;
} else {
if (_e13338 == 2u) {
phi_49787_ = _e14395;
} else {
phi_49787_ = select(_e14401, _e14398, (_e13338 == 3u));
}
let _e15903 = phi_49787_;
phi_49788_ = _e15903;
}
let _e15905 = phi_49788_;
phi_49789_ = _e15905;
}
let _e15907 = phi_49789_;
local_84 = (((bitcast<i32>(_e15907) + _e15895.member_1) * _e14392) + _e15895.member);
let _e15912 = local_84;
let _e15914 = select(_e14418, _e15912, (_e15912 < _e14418));
let _e15919 = global_6.member[bitcast<u32>(select(0i, _e15914, (_e15914 > 0i)))];
let _e15924 = (((((select(_e15885, _e15889, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e15929 = ((1f - (((select(_e15889, _e15885, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e15936 = ((_e13560.member * _e15924) + (_e13568.member * _e15929));
let _e15937 = ((_e13560.member_1 * _e15924) + (_e13568.member_1 * _e15929));
let _e15938 = ((_e13560.member_2 * _e15924) + (_e13568.member_2 * _e15929));
let _e15942 = select((_e13583.member + _e15936), _e13583.member, _e13581);
let _e15943 = select((_e13583.member_1 + _e15937), _e13583.member_1, _e13581);
let _e15944 = select((_e13583.member_2 + _e15938), _e13583.member_2, _e13581);
let _e15955 = (((_e15942 * _e15942) + (_e15943 * _e15943)) + (_e15944 * _e15944));
let _e15959 = (1f / sqrt(select(0f, _e15955, (_e15955 > 0f))));
let _e15960 = (_e15942 * _e15959);
let _e15961 = (_e15943 * _e15959);
let _e15962 = (_e15944 * _e15959);
let _e15963 = (_e593 - select(_e13594.member, (_e13594.member + _e15936), _e13581));
let _e15964 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e15937), _e13581));
let _e15965 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e15938), _e13581));
let _e15970 = (((_e15963 * _e15960) + (_e15964 * _e15961)) + (_e15965 * _e15962));
let _e15975 = (((_e15963 * _e631) + (_e15964 * _e644)) + (_e15965 * _e657));
let _e15980 = (((_e15960 * _e631) + (_e15961 * _e644)) + (_e15962 * _e657));
let _e15983 = ((_e15961 * _e657) - (_e15962 * _e644));
let _e15986 = ((_e15962 * _e631) - (_e15960 * _e657));
let _e15989 = ((_e15960 * _e644) - (_e15961 * _e631));
let _e15994 = (((_e15983 * _e15983) + (_e15986 * _e15986)) + (_e15989 * _e15989));
let _e15997 = (1f / select(1e-9f, _e15994, (_e15994 > 1e-9f)));
let _e16000 = ((_e15970 - (_e15980 * _e15975)) * _e15997);
let _e16003 = (((_e15980 * _e15970) - _e15975) * _e15997);
let _e16009 = select(0f, _e16000, (((_e16003 >= 0f) && (_e16003 < _e709)) && (_e16000 > 0f)));
let _e16011 = (_e15878 << bitcast<u32>(_e15653));
let _e16023 = (_e15709 + 1i);
if _e15719 {
phi_50773_ = (_e15669.member - 1i);
} else {
phi_50773_ = _e15718;
}
let _e16027 = phi_50773_;
let _e16029 = select(_e16023, 0i, (_e16023 < 0i));
let _e16030 = (_e16029 >= _e15669.member_1);
if _e16030 {
phi_50784_ = (_e15669.member_1 - 1i);
} else {
phi_50784_ = _e16029;
}
let _e16033 = phi_50784_;
let _e16037 = (((f32(_e16027) + 0.5f) * _e15674) - 0.5f);
let _e16041 = (((f32(_e16033) + 0.5f) * _e15674) - 0.5f);
if _e471 {
phi_50812_ = type_26(_e16033, _e16027);
} else {
phi_50812_ = type_26(_e16027, _e16033);
}
let _e16047 = phi_50812_;
if _e15745 {
phi_50863_ = 0u;
} else {
if (_e13338 == 1u) {
phi_50862_ = 0u;
} else {
if (_e13338 == 2u) {
phi_50861_ = _e14395;
} else {
phi_50861_ = select(_e14401, _e14398, (_e13338 == 3u));
}
let _e16055 = phi_50861_;
phi_50862_ = _e16055;
}
let _e16057 = phi_50862_;
phi_50863_ = _e16057;
}
let _e16059 = phi_50863_;
local_82 = (((bitcast<i32>(_e16059) + _e16047.member_1) * _e14392) + _e16047.member);
let _e16064 = local_82;
let _e16066 = select(_e14418, _e16064, (_e16064 < _e14418));
let _e16071 = global_6.member[bitcast<u32>(select(0i, _e16066, (_e16066 > 0i)))];
let _e16076 = (((((select(_e16037, _e16041, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e16081 = ((1f - (((select(_e16041, _e16037, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e16088 = ((_e13560.member * _e16076) + (_e13568.member * _e16081));
let _e16089 = ((_e13560.member_1 * _e16076) + (_e13568.member_1 * _e16081));
let _e16090 = ((_e13560.member_2 * _e16076) + (_e13568.member_2 * _e16081));
let _e16094 = select((_e13583.member + _e16088), _e13583.member, _e13581);
let _e16095 = select((_e13583.member_1 + _e16089), _e13583.member_1, _e13581);
let _e16096 = select((_e13583.member_2 + _e16090), _e13583.member_2, _e13581);
let _e16107 = (((_e16094 * _e16094) + (_e16095 * _e16095)) + (_e16096 * _e16096));
let _e16111 = (1f / sqrt(select(0f, _e16107, (_e16107 > 0f))));
let _e16112 = (_e16094 * _e16111);
let _e16113 = (_e16095 * _e16111);
let _e16114 = (_e16096 * _e16111);
let _e16115 = (_e593 - select(_e13594.member, (_e13594.member + _e16088), _e13581));
let _e16116 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e16089), _e13581));
let _e16117 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e16090), _e13581));
let _e16122 = (((_e16115 * _e16112) + (_e16116 * _e16113)) + (_e16117 * _e16114));
let _e16127 = (((_e16115 * _e631) + (_e16116 * _e644)) + (_e16117 * _e657));
let _e16132 = (((_e16112 * _e631) + (_e16113 * _e644)) + (_e16114 * _e657));
let _e16135 = ((_e16113 * _e657) - (_e16114 * _e644));
let _e16138 = ((_e16114 * _e631) - (_e16112 * _e657));
let _e16141 = ((_e16112 * _e644) - (_e16113 * _e631));
let _e16146 = (((_e16135 * _e16135) + (_e16138 * _e16138)) + (_e16141 * _e16141));
let _e16149 = (1f / select(1e-9f, _e16146, (_e16146 > 1e-9f)));
let _e16152 = ((_e16122 - (_e16132 * _e16127)) * _e16149);
let _e16155 = (((_e16132 * _e16122) - _e16127) * _e16149);
let _e16161 = select(0f, _e16152, (((_e16155 >= 0f) && (_e16155 < _e709)) && (_e16152 > 0f)));
let _e16163 = (_e16027 << bitcast<u32>(_e15653));
if _e15875 {
phi_51847_ = (_e15669.member - 1i);
} else {
phi_51847_ = _e15874;
}
let _e16178 = phi_51847_;
if _e16030 {
phi_51858_ = (_e15669.member_1 - 1i);
} else {
phi_51858_ = _e16029;
}
let _e16181 = phi_51858_;
let _e16185 = (((f32(_e16178) + 0.5f) * _e15674) - 0.5f);
let _e16189 = (((f32(_e16181) + 0.5f) * _e15674) - 0.5f);
if _e471 {
phi_51886_ = type_26(_e16181, _e16178);
} else {
phi_51886_ = type_26(_e16178, _e16181);
}
let _e16195 = phi_51886_;
if _e15745 {
phi_51937_ = 0u;
} else {
if (_e13338 == 1u) {
phi_51936_ = 0u;
} else {
if (_e13338 == 2u) {
phi_51935_ = _e14395;
} else {
phi_51935_ = select(_e14401, _e14398, (_e13338 == 3u));
}
let _e16203 = phi_51935_;
phi_51936_ = _e16203;
}
let _e16205 = phi_51936_;
phi_51937_ = _e16205;
}
let _e16207 = phi_51937_;
local_80 = (((bitcast<i32>(_e16207) + _e16195.member_1) * _e14392) + _e16195.member);
let _e16212 = local_80;
let _e16214 = select(_e14418, _e16212, (_e16212 < _e14418));
let _e16219 = global_6.member[bitcast<u32>(select(0i, _e16214, (_e16214 > 0i)))];
let _e16224 = (((((select(_e16185, _e16189, _e471) + 0.5f) / _e13541) * 2f) - 1f) * _e13549);
let _e16229 = ((1f - (((select(_e16189, _e16185, _e471) + 0.5f) / _e13542) * 2f)) * _e13557);
let _e16236 = ((_e13560.member * _e16224) + (_e13568.member * _e16229));
let _e16237 = ((_e13560.member_1 * _e16224) + (_e13568.member_1 * _e16229));
let _e16238 = ((_e13560.member_2 * _e16224) + (_e13568.member_2 * _e16229));
let _e16242 = select((_e13583.member + _e16236), _e13583.member, _e13581);
let _e16243 = select((_e13583.member_1 + _e16237), _e13583.member_1, _e13581);
let _e16244 = select((_e13583.member_2 + _e16238), _e13583.member_2, _e13581);
let _e16255 = (((_e16242 * _e16242) + (_e16243 * _e16243)) + (_e16244 * _e16244));
let _e16259 = (1f / sqrt(select(0f, _e16255, (_e16255 > 0f))));
let _e16260 = (_e16242 * _e16259);
let _e16261 = (_e16243 * _e16259);
let _e16262 = (_e16244 * _e16259);
let _e16263 = (_e593 - select(_e13594.member, (_e13594.member + _e16236), _e13581));
let _e16264 = (_e605 - select(_e13594.member_1, (_e13594.member_1 + _e16237), _e13581));
let _e16265 = (_e618 - select(_e13594.member_2, (_e13594.member_2 + _e16238), _e13581));
let _e16270 = (((_e16263 * _e16260) + (_e16264 * _e16261)) + (_e16265 * _e16262));
let _e16275 = (((_e16263 * _e631) + (_e16264 * _e644)) + (_e16265 * _e657));
let _e16280 = (((_e16260 * _e631) + (_e16261 * _e644)) + (_e16262 * _e657));
let _e16283 = ((_e16261 * _e657) - (_e16262 * _e644));
let _e16286 = ((_e16262 * _e631) - (_e16260 * _e657));
let _e16289 = ((_e16260 * _e644) - (_e16261 * _e631));
let _e16294 = (((_e16283 * _e16283) + (_e16286 * _e16286)) + (_e16289 * _e16289));
let _e16297 = (1f / select(1e-9f, _e16294, (_e16294 > 1e-9f)));
let _e16300 = ((_e16270 - (_e16280 * _e16275)) * _e16297);
let _e16303 = (((_e16280 * _e16270) - _e16275) * _e16297);
let _e16309 = select(0f, _e16300, (((_e16303 >= 0f) && (_e16303 < _e709)) && (_e16300 > 0f)));
let _e16311 = (_e16178 << bitcast<u32>(_e15653));
let _e16323 = select(((((_e15652 - select(0f, (_e15714 * _e15715), (((select(select(_e784, _e941, (_e15859 >= _e710)), _e863, (_e15859 < _e316)) == _e13338) && (_e15857 > 0f)) && (_e15857 < _e15767)))) - select(0f, (_e15711 * _e15715), (((select(select(_e784, _e941, (_e16011 >= _e710)), _e863, (_e16011 < _e316)) == _e13338) && (_e16009 > 0f)) && (_e16009 < _e15919)))) - select(0f, (_e15714 * _e15713), (((select(select(_e784, _e941, (_e16163 >= _e710)), _e863, (_e16163 < _e316)) == _e13338) && (_e16161 > 0f)) && (_e16161 < _e16071)))) - select(0f, (_e15711 * _e15713), (((select(select(_e784, _e941, (_e16311 >= _e710)), _e863, (_e16311 < _e316)) == _e13338) && (_e16309 > 0f)) && (_e16309 < _e16219)))), _e15652, _e15745);
if _e471 {
phi_52930_ = type_26(_e13446, _e13353);
} else {
phi_52930_ = type_26(_e13353, _e13446);
}
let _e16338 = phi_52930_;
let _e16341 = (_e13447 && (((_e14309 > 0f) && (_e14309 < _e13537)) && (bitcast<f32>((bitcast<u32>(_e16323) & 2147483647u)) > 1e-6f)));
let _e16344 = global_1.member.member_18.member;
let _e16345 = (((select(_e13472, (1f - _e13472), (_e13457 >= 0f)) - select(_e13491, (1f - _e13491), (_e13476 >= 0f))) * (1f / _e13454)) * _e16344);
let _e16349 = select(0f, (((((_e670 * _e14296.member) * ((1f + (_e14177 * (1f + (_e14177 * (0.5f + (_e14177 * (0.16666667f + (_e14177 * (0.041666668f + (_e14177 * (0.008333334f + (_e14177 * (0.001388889f + (_e14177 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e14172 + 127i)) << bitcast<u32>(23i))))) * _e13999) * _e16323) * _e16345), _e16341);
let _e16350 = select(0f, (((((_e683 * _e14296.member_1) * ((1f + (_e14225 * (1f + (_e14225 * (0.5f + (_e14225 * (0.16666667f + (_e14225 * (0.041666668f + (_e14225 * (0.008333334f + (_e14225 * (0.001388889f + (_e14225 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e14220 + 127i)) << bitcast<u32>(23i))))) * _e13999) * _e16323) * _e16345), _e16341);
let _e16351 = select(0f, (((((_e696 * _e14296.member_2) * ((1f + (_e14273 * (1f + (_e14273 * (0.5f + (_e14273 * (0.16666667f + (_e14273 * (0.041666668f + (_e14273 * (0.008333334f + (_e14273 * (0.001388889f + (_e14273 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e14268 + 127i)) << bitcast<u32>(23i))))) * _e13999) * _e16323) * _e16345), _e16341);
let _e16355 = (bitcast<f32>((bitcast<u32>(_e16349) & 2147483647u)) >= 1073741800f);
let _e16356 = (1f / 1048576f);
let _e16359 = ((_e16349 * select(1f, _e16356, _e16355)) + 0.5f);
let _e16361 = select(-1073741800f, _e16359, (_e16359 > -1073741800f));
let _e16363 = select(1073741800f, _e16361, (_e16361 < 1073741800f));
let _e16370 = select(0i, select(select(i32(_e16363), i32(-2147483648), (_e16363 < -2147483600f)), 2147483647i, (_e16363 > 2147483500f)), (_e16363 == _e16363));
let _e16374 = (_e16370 - select(0i, 1i, (_e16363 < f32(_e16370))));
let _e16375 = select(0i, 20i, _e16355);
let _e16379 = (bitcast<u32>(_e16374) << bitcast<u32>((_e16375 & 31i)));
let _e16386 = bitcast<u32>(((_e16374 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16375) & 31i))));
let _e16390 = (bitcast<f32>((bitcast<u32>(_e16350) & 2147483647u)) >= 1073741800f);
let _e16393 = ((_e16350 * select(1f, _e16356, _e16390)) + 0.5f);
let _e16395 = select(-1073741800f, _e16393, (_e16393 > -1073741800f));
let _e16397 = select(1073741800f, _e16395, (_e16395 < 1073741800f));
let _e16404 = select(0i, select(select(i32(_e16397), i32(-2147483648), (_e16397 < -2147483600f)), 2147483647i, (_e16397 > 2147483500f)), (_e16397 == _e16397));
let _e16408 = (_e16404 - select(0i, 1i, (_e16397 < f32(_e16404))));
let _e16409 = select(0i, 20i, _e16390);
let _e16413 = (bitcast<u32>(_e16408) << bitcast<u32>((_e16409 & 31i)));
let _e16420 = bitcast<u32>(((_e16408 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16409) & 31i))));
let _e16424 = (bitcast<f32>((bitcast<u32>(_e16351) & 2147483647u)) >= 1073741800f);
let _e16427 = ((_e16351 * select(1f, _e16356, _e16424)) + 0.5f);
let _e16429 = select(-1073741800f, _e16427, (_e16427 > -1073741800f));
let _e16431 = select(1073741800f, _e16429, (_e16429 < 1073741800f));
let _e16438 = select(0i, select(select(i32(_e16431), i32(-2147483648), (_e16431 < -2147483600f)), 2147483647i, (_e16431 > 2147483500f)), (_e16431 == _e16431));
let _e16442 = (_e16438 - select(0i, 1i, (_e16431 < f32(_e16438))));
let _e16443 = select(0i, 20i, _e16424);
let _e16447 = (bitcast<u32>(_e16442) << bitcast<u32>((_e16443 & 31i)));
let _e16454 = bitcast<u32>(((_e16442 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16443) & 31i))));
let _e16459 = bitcast<i32>(bitcast<u32>((((_e16338.member_1 * _e11931) + _e16338.member) * 6i)));
if ((_e16379 | _e16386) == 0u) {
} else {
let _e16462 = bitcast<u32>(_e16459);
if (_e16462 < _e288) {
let _e16466 = atomicAdd((&global_8.member[_e16462]), _e16379);
phi_53163_ = _e16466;
} else {
phi_53163_ = 0u;
}
let _e16468 = phi_53163_;
let _e16472 = (_e16386 + select(0u, 1u, ((_e16468 + _e16379) < _e16379)));
if (_e16472 == 0u) {
} else {
let _e16474 = (_e16462 + 1u);
if (_e16474 < _e288) {
let _e16478 = atomicAdd((&global_8.member[_e16474]), _e16472);
}
}
}
if ((_e16413 | _e16420) == 0u) {
} else {
let _e16482 = bitcast<u32>((_e16459 + 2i));
if (_e16482 < _e288) {
let _e16486 = atomicAdd((&global_8.member[_e16482]), _e16413);
phi_53193_ = _e16486;
} else {
phi_53193_ = 0u;
}
let _e16488 = phi_53193_;
let _e16492 = (_e16420 + select(0u, 1u, ((_e16488 + _e16413) < _e16413)));
if (_e16492 == 0u) {
} else {
let _e16494 = (_e16482 + 1u);
if (_e16494 < _e288) {
let _e16498 = atomicAdd((&global_8.member[_e16494]), _e16492);
}
}
}
if ((_e16447 | _e16454) == 0u) {
} else {
let _e16502 = bitcast<u32>((_e16459 + 4i));
if (_e16502 < _e288) {
let _e16506 = atomicAdd((&global_8.member[_e16502]), _e16447);
phi_53223_ = _e16506;
} else {
phi_53223_ = 0u;
}
let _e16508 = phi_53223_;
let _e16512 = (_e16454 + select(0u, 1u, ((_e16508 + _e16447) < _e16447)));
if (_e16512 == 0u) {
} else {
let _e16514 = (_e16502 + 1u);
if (_e16514 < _e288) {
let _e16518 = atomicAdd((&global_8.member[_e16514]), _e16512);
}
}
}
phi_38354_ = (_e13444 + 1i);
} else {
phi_38354_ = i32();
}
let _e16521 = phi_38354_;
continue;
continuing {
phi_38353_ = _e16521;
break if !(_e13447);
}
}
phi_38200_ = (_e13350 + 1i);
} else {
phi_38200_ = i32();
}
let _e16525 = phi_38200_;
continue;
continuing {
phi_38199_ = _e16525;
break if !(_e13351);
}
}
}
}
}
}
} else {
let _e946 = global_1.member.member_1.member;
let _e949 = global_1.member.member_1.member_1;
let _e950 = bitcast<i32>(_e946);
let _e951 = bitcast<i32>(_e949);
if _e471 {
phi_53290_ = type_26(_e951, _e950);
} else {
phi_53290_ = type_26(_e950, _e951);
}
let _e955 = phi_53290_;
let _e959 = f32((_e316 + 15i));
let _e961 = select(_e959, _e396, (_e396 < _e959));
let _e963 = select(_e332, _e961, (_e961 > _e332));
let _e965 = select(_e959, _e963, (_e963 < _e959));
let _e972 = select(0i, select(select(i32(_e965), i32(-2147483648), (_e965 < -2147483600f)), 2147483647i, (_e965 > 2147483500f)), (_e965 == _e965));
let _e976 = (_e972 - select(0i, 1i, (_e965 < f32(_e972))));
let _e977 = bitcast<i32>(_e976);
let _e979 = select(_e332, _e383, (_e383 > _e332));
let _e981 = select(_e332, _e979, (_e979 > _e332));
let _e983 = select(_e959, _e981, (_e981 < _e959));
let _e990 = select(0i, select(select(i32(_e983), i32(-2147483648), (_e983 < -2147483600f)), 2147483647i, (_e983 > 2147483500f)), (_e983 == _e983));
let _e994 = (_e990 - select(0i, 1i, (_e983 < f32(_e990))));
let _e995 = bitcast<i32>(_e994);
if (_e977 < _e955.member) {
phi_53365_ = _e977;
} else {
phi_53365_ = (_e955.member - 1i);
}
let _e999 = phi_53365_;
let _e1000 = (_e955.member_1 - 1i);
let _e1001 = (_e784 == 0u);
if _e1001 {
let _e6931 = select(_e863, 0u, (_e863 == _e784));
let _e6935 = select(_e941, 0u, ((_e941 == _e784) || (_e941 == _e863)));
let _e6943 = ((select(0u, 1u, (_e784 > 0u)) + select(0u, 1u, (_e6931 > 0u))) + select(0u, 1u, (_e6935 > 0u)));
if (_e6943 == 0u) {
phi_53403_ = 0i;
loop {
let _e11174 = phi_53403_;
let _e11175 = (_e11174 < 16i);
if _e11175 {
let _e11177 = (_e995 + (_e11174 & 15i));
let _e11181 = (((f32(_e11177) + 0.5f) * 1f) - 0.5f);
let _e11185 = (-(((_e434 * _e11181) + _e460)) / _e447);
let _e11192 = bitcast<f32>((bitcast<u32>(((_e484 * _e11181) + ((_e497 * _e11185) + _e510))) & 2147483647u));
let _e11199 = bitcast<f32>((bitcast<u32>(((_e523 * _e11181) + ((_e536 * _e11185) + _e549))) & 2147483647u));
let _e11203 = (((0.5f * (_e11192 + _e11199)) / _e552) + _e735);
let _e11204 = (1f / 1f);
let _e11212 = ((((_e11185 + _e11203) + 0.5f) * _e11204) - 0.5f);
let _e11213 = f32(_e1000);
let _e11214 = (0f - 1f);
let _e11216 = select(_e11214, _e11212, (_e11212 > _e11214));
let _e11218 = select(_e11213, _e11216, (_e11216 < _e11213));
let _e11225 = select(0i, select(select(i32(_e11218), i32(-2147483648), (_e11218 < -2147483600f)), 2147483647i, (_e11218 > 2147483500f)), (_e11218 == _e11218));
let _e11230 = (((((_e11185 - _e11203) + 0.5f) * _e11204) - 0.5f) + 1f);
let _e11231 = (_e11213 + 1f);
let _e11233 = select(0f, _e11230, (_e11230 > 0f));
let _e11235 = select(_e11231, _e11233, (_e11233 < _e11231));
let _e11242 = select(0i, select(select(i32(_e11235), i32(-2147483648), (_e11235 < -2147483600f)), 2147483647i, (_e11235 > 2147483500f)), (_e11235 == _e11235));
let _e11253 = ((1e-4f * 1f) * _e552);
let _e11255 = select(_e11199, _e11192, (_e11192 > _e11199));
let _e11257 = select(_e11253, _e11255, (_e11255 > _e11253));
let _e11259 = select(_e11199, _e11192, (_e11192 < _e11199));
let _e11261 = select(_e11253, _e11259, (_e11259 > _e11253));
let _e11263 = (0.5f * (_e11257 + _e11261));
let _e11264 = (0.5f / _e11261);
let _e11265 = (1f / _e11257);
phi_53557_ = 0i;
loop {
let _e11267 = phi_53557_;
let _e11269 = (((_e11242 - select(0i, 1i, (_e11235 < f32(_e11242)))) + (_e11174 >> bitcast<u32>(4u))) + bitcast<i32>(_e11267));
let _e11270 = (_e11269 <= select(-1i, (_e11225 - select(0i, 1i, (_e11218 < f32(_e11225)))), (_e11177 <= _e999)));
if _e11270 {
let _e11276 = (((((f32(_e11269) + 0.5f) * 1f) - 0.5f) - _e11185) * _e552);
let _e11277 = (_e552 * 1f);
let _e11279 = (0.5f * _e11277);
let _e11280 = (_e11276 + _e11279);
let _e11281 = -(_e11280);
let _e11284 = (_e11263 - select(_e11281, _e11280, (_e11280 > _e11281)));
let _e11286 = select(0f, _e11284, (_e11284 > 0f));
let _e11288 = select(_e11261, _e11286, (_e11286 < _e11261));
let _e11291 = (_e11284 - _e11261);
let _e11295 = (((_e11288 * (_e11288 * _e11264)) + select(0f, _e11291, (_e11291 > 0f))) * _e11265);
let _e11299 = (_e11276 - _e11279);
let _e11300 = -(_e11299);
let _e11303 = (_e11263 - select(_e11300, _e11299, (_e11299 > _e11300)));
let _e11305 = select(0f, _e11303, (_e11303 > 0f));
let _e11307 = select(_e11261, _e11305, (_e11305 < _e11261));
let _e11310 = (_e11303 - _e11261);
let _e11314 = (((_e11307 * (_e11307 * _e11264)) + select(0f, _e11310, (_e11310 > 0f))) * _e11265);
if _e471 {
phi_53662_ = type_26(_e11269, _e11177);
} else {
phi_53662_ = type_26(_e11177, _e11269);
}
let _e11323 = phi_53662_;
local_78 = bitcast<i32>((_e946 * _e949));
local_79 = ((_e11323.member_1 * _e950) + _e11323.member);
let _e11330 = local_78;
let _e11331 = local_79;
let _e11332 = (_e11330 + _e11331);
let _e11334 = (bitcast<i32>(_e277) - 1i);
let _e11336 = select(_e11334, _e11332, (_e11332 < _e11334));
let _e11341 = global_5.member[bitcast<u32>(select(0i, _e11336, (_e11336 > 0i)))];
let _e11342 = local_79;
let _e11344 = select(_e11334, _e11342, (_e11342 < _e11334));
let _e11349 = global_5.member[bitcast<u32>(select(0i, _e11344, (_e11344 > 0i)))];
let _e11360 = global_1.member.member_2.member;
let _e11361 = (((((f32(_e11323.member) + 0.5f) / f32(_e950)) * 2f) - 1f) * _e11360);
let _e11368 = global_1.member.member_2.member_1;
let _e11369 = ((1f - (((f32(_e11323.member_1) + 0.5f) / f32(_e951)) * 2f)) * _e11368);
let _e11371 = global_1.member.member_3;
let _e11379 = global_1.member.member_4;
let _e11386 = ((_e11371.member * _e11361) + (_e11379.member * _e11369));
let _e11387 = ((_e11371.member_1 * _e11361) + (_e11379.member_1 * _e11369));
let _e11388 = ((_e11371.member_2 * _e11361) + (_e11379.member_2 * _e11369));
let _e11391 = global_1.member.member_2.member_3;
let _e11392 = (_e11391 != 0u);
let _e11394 = global_1.member.member_5;
let _e11401 = select((_e11394.member + _e11386), _e11394.member, _e11392);
let _e11402 = select((_e11394.member_1 + _e11387), _e11394.member_1, _e11392);
let _e11403 = select((_e11394.member_2 + _e11388), _e11394.member_2, _e11392);
let _e11405 = global_1.member.member_6;
let _e11419 = (((_e11401 * _e11401) + (_e11402 * _e11402)) + (_e11403 * _e11403));
let _e11422 = sqrt(select(0f, _e11419, (_e11419 > 0f)));
let _e11423 = (1f / _e11422);
let _e11424 = (_e11401 * _e11423);
let _e11425 = (_e11402 * _e11423);
let _e11426 = (_e11403 * _e11423);
let _e11427 = (_e593 - select(_e11405.member, (_e11405.member + _e11386), _e11392));
let _e11428 = (_e605 - select(_e11405.member_1, (_e11405.member_1 + _e11387), _e11392));
let _e11429 = (_e618 - select(_e11405.member_2, (_e11405.member_2 + _e11388), _e11392));
let _e11434 = (((_e11427 * _e11424) + (_e11428 * _e11425)) + (_e11429 * _e11426));
let _e11439 = (((_e11427 * _e631) + (_e11428 * _e644)) + (_e11429 * _e657));
let _e11444 = (((_e11424 * _e631) + (_e11425 * _e644)) + (_e11426 * _e657));
let _e11447 = ((_e11425 * _e657) - (_e11426 * _e644));
let _e11450 = ((_e11426 * _e631) - (_e11424 * _e657));
let _e11453 = ((_e11424 * _e644) - (_e11425 * _e631));
let _e11458 = (((_e11447 * _e11447) + (_e11450 * _e11450)) + (_e11453 * _e11453));
let _e11461 = (1f / select(1e-9f, _e11458, (_e11458 > 1e-9f)));
let _e11464 = ((_e11434 - (_e11444 * _e11439)) * _e11461);
let _e11467 = (((_e11444 * _e11434) - _e11439) * _e11461);
let _e11473 = -(_e11444);
let _e11476 = global_1.member.member_13.member_2;
let _e11477 = (_e11476 * _e11476);
let _e11481 = ((1f + _e11477) - ((2f * _e11476) * _e11473));
let _e11483 = select(1e-9f, _e11481, (_e11481 > 1e-9f));
let _e11495 = global_1.member.member_13.member_3;
if (_e11495 == 2u) {
let _e11500 = (0.5f - (0.5f * _e11473));
let _e11502 = select(0f, _e11500, (_e11500 > 0f));
let _e11506 = (sqrt(select(0f, _e11502, (_e11502 > 0f))) * 255f);
let _e11507 = (255f - 1f);
let _e11509 = select(0f, _e11506, (_e11506 > 0f));
let _e11511 = select(_e11507, _e11509, (_e11509 < _e11507));
let _e11518 = select(0i, select(select(i32(_e11511), i32(-2147483648), (_e11511 < -2147483600f)), 2147483647i, (_e11511 > 2147483500f)), (_e11511 == _e11511));
let _e11522 = (_e11518 - select(0i, 1i, (_e11511 < f32(_e11518))));
let _e11525 = global_1.member.member_13.member_11;
let _e11526 = bitcast<i32>(_e11525);
let _e11527 = (_e11526 + _e11522);
let _e11529 = (bitcast<i32>(_e283) - 1i);
let _e11531 = select(_e11529, _e11527, (_e11527 < _e11529));
let _e11536 = global_2.member[bitcast<u32>(select(0i, _e11531, (_e11531 > 0i)))];
let _e11538 = (_e11526 + (_e11522 + 1i));
let _e11540 = select(_e11529, _e11538, (_e11538 < _e11529));
let _e11545 = global_2.member[bitcast<u32>(select(0i, _e11540, (_e11540 > 0i)))];
phi_54089_ = (_e11536 + ((_e11545 - _e11536) * (_e11506 - f32(_e11522))));
} else {
phi_54089_ = select(((1f - _e11477) / (_e11483 * sqrt(select(0f, _e11483, (_e11483 > 0f))))), (0.75f * (1f + (_e11473 * _e11473))), (_e11495 == 1u));
}
let _e11552 = phi_54089_;
let _e11555 = (_e11422 * (_e11552 * (0.25f / 3.1415927f)));
let _e11556 = (_e11464 - _e11341);
let _e11559 = (_e11467 + select(0f, _e11556, (_e11556 > 0f)));
let _e11562 = global_1.member.member_13.member;
let _e11567 = -((_e11562.member * _e11559));
let _e11569 = select(-87f, _e11567, (_e11567 > -87f));
let _e11571 = select(88f, _e11569, (_e11569 < 88f));
let _e11573 = ((_e11571 * 1.442695f) + 0.5f);
let _e11575 = select(-127f, _e11573, (_e11573 > -127f));
let _e11577 = select(128f, _e11575, (_e11575 < 128f));
let _e11584 = select(0i, select(select(i32(_e11577), i32(-2147483648), (_e11577 < -2147483600f)), 2147483647i, (_e11577 > 2147483500f)), (_e11577 == _e11577));
let _e11588 = (_e11584 - select(0i, 1i, (_e11577 < f32(_e11584))));
let _e11589 = f32(_e11588);
let _e11593 = ((_e11571 - (_e11589 * 0.6933594f)) - (_e11589 * -2.1219444e-4f));
let _e11615 = -((_e11562.member_1 * _e11559));
let _e11617 = select(-87f, _e11615, (_e11615 > -87f));
let _e11619 = select(88f, _e11617, (_e11617 < 88f));
let _e11621 = ((_e11619 * 1.442695f) + 0.5f);
let _e11623 = select(-127f, _e11621, (_e11621 > -127f));
let _e11625 = select(128f, _e11623, (_e11623 < 128f));
let _e11632 = select(0i, select(select(i32(_e11625), i32(-2147483648), (_e11625 < -2147483600f)), 2147483647i, (_e11625 > 2147483500f)), (_e11625 == _e11625));
let _e11636 = (_e11632 - select(0i, 1i, (_e11625 < f32(_e11632))));
let _e11637 = f32(_e11636);
let _e11641 = ((_e11619 - (_e11637 * 0.6933594f)) - (_e11637 * -2.1219444e-4f));
let _e11663 = -((_e11562.member_2 * _e11559));
let _e11665 = select(-87f, _e11663, (_e11663 > -87f));
let _e11667 = select(88f, _e11665, (_e11665 < 88f));
let _e11669 = ((_e11667 * 1.442695f) + 0.5f);
let _e11671 = select(-127f, _e11669, (_e11669 > -127f));
let _e11673 = select(128f, _e11671, (_e11671 < 128f));
let _e11680 = select(0i, select(select(i32(_e11673), i32(-2147483648), (_e11673 < -2147483600f)), 2147483647i, (_e11673 > 2147483500f)), (_e11673 == _e11673));
let _e11684 = (_e11680 - select(0i, 1i, (_e11673 < f32(_e11680))));
let _e11685 = f32(_e11684);
let _e11689 = ((_e11667 - (_e11685 * 0.6933594f)) - (_e11685 * -2.1219444e-4f));
let _e11712 = global_1.member.member_13.member_1;
let _e11725 = select(0f, _e11464, (((_e11467 >= 0f) && (_e11467 < _e709)) && (_e11464 > 0f)));
if _e471 {
phi_54691_ = type_26(_e11269, _e11177);
} else {
phi_54691_ = type_26(_e11177, _e11269);
}
let _e11736 = phi_54691_;
let _e11739 = (_e11270 && (((_e11725 > 0f) && (_e11725 < _e11349)) && true));
let _e11742 = global_1.member.member_18.member;
let _e11743 = (((select(_e11295, (1f - _e11295), (_e11280 >= 0f)) - select(_e11314, (1f - _e11314), (_e11299 >= 0f))) * (1f / _e11277)) * _e11742);
let _e11747 = select(0f, (((((_e670 * _e11712.member) * ((1f + (_e11593 * (1f + (_e11593 * (0.5f + (_e11593 * (0.16666667f + (_e11593 * (0.041666668f + (_e11593 * (0.008333334f + (_e11593 * (0.001388889f + (_e11593 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e11588 + 127i)) << bitcast<u32>(23i))))) * _e11555) * 1f) * _e11743), _e11739);
let _e11748 = select(0f, (((((_e683 * _e11712.member_1) * ((1f + (_e11641 * (1f + (_e11641 * (0.5f + (_e11641 * (0.16666667f + (_e11641 * (0.041666668f + (_e11641 * (0.008333334f + (_e11641 * (0.001388889f + (_e11641 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e11636 + 127i)) << bitcast<u32>(23i))))) * _e11555) * 1f) * _e11743), _e11739);
let _e11749 = select(0f, (((((_e696 * _e11712.member_2) * ((1f + (_e11689 * (1f + (_e11689 * (0.5f + (_e11689 * (0.16666667f + (_e11689 * (0.041666668f + (_e11689 * (0.008333334f + (_e11689 * (0.001388889f + (_e11689 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e11684 + 127i)) << bitcast<u32>(23i))))) * _e11555) * 1f) * _e11743), _e11739);
let _e11753 = (bitcast<f32>((bitcast<u32>(_e11747) & 2147483647u)) >= 1073741800f);
let _e11754 = (1f / 1048576f);
let _e11757 = ((_e11747 * select(1f, _e11754, _e11753)) + 0.5f);
let _e11759 = select(-1073741800f, _e11757, (_e11757 > -1073741800f));
let _e11761 = select(1073741800f, _e11759, (_e11759 < 1073741800f));
let _e11768 = select(0i, select(select(i32(_e11761), i32(-2147483648), (_e11761 < -2147483600f)), 2147483647i, (_e11761 > 2147483500f)), (_e11761 == _e11761));
let _e11772 = (_e11768 - select(0i, 1i, (_e11761 < f32(_e11768))));
let _e11773 = select(0i, 20i, _e11753);
let _e11777 = (bitcast<u32>(_e11772) << bitcast<u32>((_e11773 & 31i)));
let _e11784 = bitcast<u32>(((_e11772 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11773) & 31i))));
let _e11788 = (bitcast<f32>((bitcast<u32>(_e11748) & 2147483647u)) >= 1073741800f);
let _e11791 = ((_e11748 * select(1f, _e11754, _e11788)) + 0.5f);
let _e11793 = select(-1073741800f, _e11791, (_e11791 > -1073741800f));
let _e11795 = select(1073741800f, _e11793, (_e11793 < 1073741800f));
let _e11802 = select(0i, select(select(i32(_e11795), i32(-2147483648), (_e11795 < -2147483600f)), 2147483647i, (_e11795 > 2147483500f)), (_e11795 == _e11795));
let _e11806 = (_e11802 - select(0i, 1i, (_e11795 < f32(_e11802))));
let _e11807 = select(0i, 20i, _e11788);
let _e11811 = (bitcast<u32>(_e11806) << bitcast<u32>((_e11807 & 31i)));
let _e11818 = bitcast<u32>(((_e11806 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11807) & 31i))));
let _e11822 = (bitcast<f32>((bitcast<u32>(_e11749) & 2147483647u)) >= 1073741800f);
let _e11825 = ((_e11749 * select(1f, _e11754, _e11822)) + 0.5f);
let _e11827 = select(-1073741800f, _e11825, (_e11825 > -1073741800f));
let _e11829 = select(1073741800f, _e11827, (_e11827 < 1073741800f));
let _e11836 = select(0i, select(select(i32(_e11829), i32(-2147483648), (_e11829 < -2147483600f)), 2147483647i, (_e11829 > 2147483500f)), (_e11829 == _e11829));
let _e11840 = (_e11836 - select(0i, 1i, (_e11829 < f32(_e11836))));
let _e11841 = select(0i, 20i, _e11822);
let _e11845 = (bitcast<u32>(_e11840) << bitcast<u32>((_e11841 & 31i)));
let _e11852 = bitcast<u32>(((_e11840 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11841) & 31i))));
let _e11857 = bitcast<i32>(bitcast<u32>((((_e11736.member_1 * _e950) + _e11736.member) * 6i)));
if ((_e11777 | _e11784) == 0u) {
} else {
let _e11860 = bitcast<u32>(_e11857);
if (_e11860 < _e288) {
let _e11864 = atomicAdd((&global_8.member[_e11860]), _e11777);
phi_54924_ = _e11864;
} else {
phi_54924_ = 0u;
}
let _e11866 = phi_54924_;
let _e11870 = (_e11784 + select(0u, 1u, ((_e11866 + _e11777) < _e11777)));
if (_e11870 == 0u) {
} else {
let _e11872 = (_e11860 + 1u);
if (_e11872 < _e288) {
let _e11876 = atomicAdd((&global_8.member[_e11872]), _e11870);
}
}
}
if ((_e11811 | _e11818) == 0u) {
} else {
let _e11880 = bitcast<u32>((_e11857 + 2i));
if (_e11880 < _e288) {
let _e11884 = atomicAdd((&global_8.member[_e11880]), _e11811);
phi_54954_ = _e11884;
} else {
phi_54954_ = 0u;
}
let _e11886 = phi_54954_;
let _e11890 = (_e11818 + select(0u, 1u, ((_e11886 + _e11811) < _e11811)));
if (_e11890 == 0u) {
} else {
let _e11892 = (_e11880 + 1u);
if (_e11892 < _e288) {
let _e11896 = atomicAdd((&global_8.member[_e11892]), _e11890);
}
}
}
if ((_e11845 | _e11852) == 0u) {
} else {
let _e11900 = bitcast<u32>((_e11857 + 4i));
if (_e11900 < _e288) {
let _e11904 = atomicAdd((&global_8.member[_e11900]), _e11845);
phi_54984_ = _e11904;
} else {
phi_54984_ = 0u;
}
let _e11906 = phi_54984_;
let _e11910 = (_e11852 + select(0u, 1u, ((_e11906 + _e11845) < _e11845)));
if (_e11910 == 0u) {
} else {
let _e11912 = (_e11900 + 1u);
if (_e11912 < _e288) {
let _e11916 = atomicAdd((&global_8.member[_e11912]), _e11910);
}
}
}
phi_53558_ = (_e11267 + 1i);
} else {
phi_53558_ = i32();
}
let _e11919 = phi_53558_;
continue;
continuing {
phi_53557_ = _e11919;
break if !(_e11270);
}
}
phi_53404_ = (_e11174 + 1i);
} else {
phi_53404_ = i32();
}
let _e11923 = phi_53404_;
continue;
continuing {
phi_53403_ = _e11923;
break if !(_e11175);
}
}
} else {
if (_e6943 == 1u) {
phi_55033_ = 0i;
loop {
let _e9730 = phi_55033_;
let _e9731 = (_e9730 < 16i);
if _e9731 {
let _e9733 = (_e995 + (_e9730 & 15i));
let _e9735 = (f32(_e9733) + 0.5f);
let _e9737 = ((_e9735 * 1f) - 0.5f);
let _e9741 = (-(((_e434 * _e9737) + _e460)) / _e447);
let _e9748 = bitcast<f32>((bitcast<u32>(((_e484 * _e9737) + ((_e497 * _e9741) + _e510))) & 2147483647u));
let _e9755 = bitcast<f32>((bitcast<u32>(((_e523 * _e9737) + ((_e536 * _e9741) + _e549))) & 2147483647u));
let _e9759 = (((0.5f * (_e9748 + _e9755)) / _e552) + _e735);
let _e9760 = (1f / 1f);
let _e9768 = ((((_e9741 + _e9759) + 0.5f) * _e9760) - 0.5f);
let _e9769 = f32(_e1000);
let _e9770 = (0f - 1f);
let _e9772 = select(_e9770, _e9768, (_e9768 > _e9770));
let _e9774 = select(_e9769, _e9772, (_e9772 < _e9769));
let _e9781 = select(0i, select(select(i32(_e9774), i32(-2147483648), (_e9774 < -2147483600f)), 2147483647i, (_e9774 > 2147483500f)), (_e9774 == _e9774));
let _e9786 = (((((_e9741 - _e9759) + 0.5f) * _e9760) - 0.5f) + 1f);
let _e9787 = (_e9769 + 1f);
let _e9789 = select(0f, _e9786, (_e9786 > 0f));
let _e9791 = select(_e9787, _e9789, (_e9789 < _e9787));
let _e9798 = select(0i, select(select(i32(_e9791), i32(-2147483648), (_e9791 < -2147483600f)), 2147483647i, (_e9791 > 2147483500f)), (_e9791 == _e9791));
let _e9809 = ((1e-4f * 1f) * _e552);
let _e9811 = select(_e9755, _e9748, (_e9748 > _e9755));
let _e9813 = select(_e9809, _e9811, (_e9811 > _e9809));
let _e9815 = select(_e9755, _e9748, (_e9748 < _e9755));
let _e9817 = select(_e9809, _e9815, (_e9815 > _e9809));
let _e9819 = (0.5f * (_e9813 + _e9817));
let _e9820 = (0.5f / _e9817);
let _e9821 = (1f / _e9813);
phi_55187_ = 0i;
loop {
let _e9823 = phi_55187_;
let _e9825 = (((_e9798 - select(0i, 1i, (_e9791 < f32(_e9798)))) + (_e9730 >> bitcast<u32>(4u))) + bitcast<i32>(_e9823));
let _e9826 = (_e9825 <= select(-1i, (_e9781 - select(0i, 1i, (_e9774 < f32(_e9781)))), (_e9733 <= _e999)));
if _e9826 {
let _e9828 = (f32(_e9825) + 0.5f);
let _e9832 = ((((_e9828 * 1f) - 0.5f) - _e9741) * _e552);
let _e9833 = (_e552 * 1f);
let _e9835 = (0.5f * _e9833);
let _e9836 = (_e9832 + _e9835);
let _e9837 = -(_e9836);
let _e9840 = (_e9819 - select(_e9837, _e9836, (_e9836 > _e9837)));
let _e9842 = select(0f, _e9840, (_e9840 > 0f));
let _e9844 = select(_e9817, _e9842, (_e9842 < _e9817));
let _e9847 = (_e9840 - _e9817);
let _e9851 = (((_e9844 * (_e9844 * _e9820)) + select(0f, _e9847, (_e9847 > 0f))) * _e9821);
let _e9855 = (_e9832 - _e9835);
let _e9856 = -(_e9855);
let _e9859 = (_e9819 - select(_e9856, _e9855, (_e9855 > _e9856)));
let _e9861 = select(0f, _e9859, (_e9859 > 0f));
let _e9863 = select(_e9817, _e9861, (_e9861 < _e9817));
let _e9866 = (_e9859 - _e9817);
let _e9870 = (((_e9863 * (_e9863 * _e9820)) + select(0f, _e9866, (_e9866 > 0f))) * _e9821);
if _e471 {
phi_55292_ = type_26(_e9825, _e9733);
} else {
phi_55292_ = type_26(_e9733, _e9825);
}
let _e9879 = phi_55292_;
local_76 = bitcast<i32>((_e946 * _e949));
local_77 = ((_e9879.member_1 * _e950) + _e9879.member);
let _e9886 = local_76;
let _e9887 = local_77;
let _e9888 = (_e9886 + _e9887);
let _e9890 = (bitcast<i32>(_e277) - 1i);
let _e9892 = select(_e9890, _e9888, (_e9888 < _e9890));
let _e9897 = global_5.member[bitcast<u32>(select(0i, _e9892, (_e9892 > 0i)))];
let _e9898 = local_77;
let _e9900 = select(_e9890, _e9898, (_e9898 < _e9890));
let _e9905 = global_5.member[bitcast<u32>(select(0i, _e9900, (_e9900 > 0i)))];
let _e9908 = f32(_e950);
let _e9909 = f32(_e951);
let _e9916 = global_1.member.member_2.member;
let _e9917 = (((((f32(_e9879.member) + 0.5f) / _e9908) * 2f) - 1f) * _e9916);
let _e9924 = global_1.member.member_2.member_1;
let _e9925 = ((1f - (((f32(_e9879.member_1) + 0.5f) / _e9909) * 2f)) * _e9924);
let _e9927 = global_1.member.member_3;
let _e9935 = global_1.member.member_4;
let _e9942 = ((_e9927.member * _e9917) + (_e9935.member * _e9925));
let _e9943 = ((_e9927.member_1 * _e9917) + (_e9935.member_1 * _e9925));
let _e9944 = ((_e9927.member_2 * _e9917) + (_e9935.member_2 * _e9925));
let _e9947 = global_1.member.member_2.member_3;
let _e9948 = (_e9947 != 0u);
let _e9950 = global_1.member.member_5;
let _e9957 = select((_e9950.member + _e9942), _e9950.member, _e9948);
let _e9958 = select((_e9950.member_1 + _e9943), _e9950.member_1, _e9948);
let _e9959 = select((_e9950.member_2 + _e9944), _e9950.member_2, _e9948);
let _e9961 = global_1.member.member_6;
let _e9975 = (((_e9957 * _e9957) + (_e9958 * _e9958)) + (_e9959 * _e9959));
let _e9978 = sqrt(select(0f, _e9975, (_e9975 > 0f)));
let _e9979 = (1f / _e9978);
let _e9980 = (_e9957 * _e9979);
let _e9981 = (_e9958 * _e9979);
let _e9982 = (_e9959 * _e9979);
let _e9983 = (_e593 - select(_e9961.member, (_e9961.member + _e9942), _e9948));
let _e9984 = (_e605 - select(_e9961.member_1, (_e9961.member_1 + _e9943), _e9948));
let _e9985 = (_e618 - select(_e9961.member_2, (_e9961.member_2 + _e9944), _e9948));
let _e9990 = (((_e9983 * _e9980) + (_e9984 * _e9981)) + (_e9985 * _e9982));
let _e9995 = (((_e9983 * _e631) + (_e9984 * _e644)) + (_e9985 * _e657));
let _e10000 = (((_e9980 * _e631) + (_e9981 * _e644)) + (_e9982 * _e657));
let _e10003 = ((_e9981 * _e657) - (_e9982 * _e644));
let _e10006 = ((_e9982 * _e631) - (_e9980 * _e657));
let _e10009 = ((_e9980 * _e644) - (_e9981 * _e631));
let _e10014 = (((_e10003 * _e10003) + (_e10006 * _e10006)) + (_e10009 * _e10009));
let _e10017 = (1f / select(1e-9f, _e10014, (_e10014 > 1e-9f)));
let _e10020 = ((_e9990 - (_e10000 * _e9995)) * _e10017);
let _e10023 = (((_e10000 * _e9990) - _e9995) * _e10017);
let _e10029 = -(_e10000);
let _e10032 = global_1.member.member_13.member_2;
let _e10033 = (_e10032 * _e10032);
let _e10037 = ((1f + _e10033) - ((2f * _e10032) * _e10029));
let _e10039 = select(1e-9f, _e10037, (_e10037 > 1e-9f));
let _e10051 = global_1.member.member_13.member_3;
if (_e10051 == 2u) {
let _e10056 = (0.5f - (0.5f * _e10029));
let _e10058 = select(0f, _e10056, (_e10056 > 0f));
let _e10062 = (sqrt(select(0f, _e10058, (_e10058 > 0f))) * 255f);
let _e10063 = (255f - 1f);
let _e10065 = select(0f, _e10062, (_e10062 > 0f));
let _e10067 = select(_e10063, _e10065, (_e10065 < _e10063));
let _e10074 = select(0i, select(select(i32(_e10067), i32(-2147483648), (_e10067 < -2147483600f)), 2147483647i, (_e10067 > 2147483500f)), (_e10067 == _e10067));
let _e10078 = (_e10074 - select(0i, 1i, (_e10067 < f32(_e10074))));
let _e10081 = global_1.member.member_13.member_11;
let _e10082 = bitcast<i32>(_e10081);
let _e10083 = (_e10082 + _e10078);
let _e10085 = (bitcast<i32>(_e283) - 1i);
let _e10087 = select(_e10085, _e10083, (_e10083 < _e10085));
let _e10092 = global_2.member[bitcast<u32>(select(0i, _e10087, (_e10087 > 0i)))];
let _e10094 = (_e10082 + (_e10078 + 1i));
let _e10096 = select(_e10085, _e10094, (_e10094 < _e10085));
let _e10101 = global_2.member[bitcast<u32>(select(0i, _e10096, (_e10096 > 0i)))];
phi_55719_ = (_e10092 + ((_e10101 - _e10092) * (_e10062 - f32(_e10078))));
} else {
phi_55719_ = select(((1f - _e10033) / (_e10039 * sqrt(select(0f, _e10039, (_e10039 > 0f))))), (0.75f * (1f + (_e10029 * _e10029))), (_e10051 == 1u));
}
let _e10108 = phi_55719_;
let _e10111 = (_e9978 * (_e10108 * (0.25f / 3.1415927f)));
let _e10112 = (_e10020 - _e9897);
let _e10115 = (_e10023 + select(0f, _e10112, (_e10112 > 0f)));
let _e10118 = global_1.member.member_13.member;
let _e10123 = -((_e10118.member * _e10115));
let _e10125 = select(-87f, _e10123, (_e10123 > -87f));
let _e10127 = select(88f, _e10125, (_e10125 < 88f));
let _e10129 = ((_e10127 * 1.442695f) + 0.5f);
let _e10131 = select(-127f, _e10129, (_e10129 > -127f));
let _e10133 = select(128f, _e10131, (_e10131 < 128f));
let _e10140 = select(0i, select(select(i32(_e10133), i32(-2147483648), (_e10133 < -2147483600f)), 2147483647i, (_e10133 > 2147483500f)), (_e10133 == _e10133));
let _e10144 = (_e10140 - select(0i, 1i, (_e10133 < f32(_e10140))));
let _e10145 = f32(_e10144);
let _e10149 = ((_e10127 - (_e10145 * 0.6933594f)) - (_e10145 * -2.1219444e-4f));
let _e10171 = -((_e10118.member_1 * _e10115));
let _e10173 = select(-87f, _e10171, (_e10171 > -87f));
let _e10175 = select(88f, _e10173, (_e10173 < 88f));
let _e10177 = ((_e10175 * 1.442695f) + 0.5f);
let _e10179 = select(-127f, _e10177, (_e10177 > -127f));
let _e10181 = select(128f, _e10179, (_e10179 < 128f));
let _e10188 = select(0i, select(select(i32(_e10181), i32(-2147483648), (_e10181 < -2147483600f)), 2147483647i, (_e10181 > 2147483500f)), (_e10181 == _e10181));
let _e10192 = (_e10188 - select(0i, 1i, (_e10181 < f32(_e10188))));
let _e10193 = f32(_e10192);
let _e10197 = ((_e10175 - (_e10193 * 0.6933594f)) - (_e10193 * -2.1219444e-4f));
let _e10219 = -((_e10118.member_2 * _e10115));
let _e10221 = select(-87f, _e10219, (_e10219 > -87f));
let _e10223 = select(88f, _e10221, (_e10221 < 88f));
let _e10225 = ((_e10223 * 1.442695f) + 0.5f);
let _e10227 = select(-127f, _e10225, (_e10225 > -127f));
let _e10229 = select(128f, _e10227, (_e10227 < 128f));
let _e10236 = select(0i, select(select(i32(_e10229), i32(-2147483648), (_e10229 < -2147483600f)), 2147483647i, (_e10229 > 2147483500f)), (_e10229 == _e10229));
let _e10240 = (_e10236 - select(0i, 1i, (_e10229 < f32(_e10236))));
let _e10241 = f32(_e10240);
let _e10245 = ((_e10223 - (_e10241 * 0.6933594f)) - (_e10241 * -2.1219444e-4f));
let _e10268 = global_1.member.member_13.member_1;
let _e10281 = select(0f, _e10020, (((_e10023 >= 0f) && (_e10023 < _e709)) && (_e10020 > 0f)));
let _e10283 = ((_e784 + _e6931) + _e6935);
let _e10284 = (_e10283 & 31u);
let _e10286 = (1u << bitcast<u32>(_e10284));
let _e10295 = bitcast<i32>((((_e946 + _e10286) - 1u) >> bitcast<u32>(_e10284)));
let _e10296 = bitcast<i32>((((_e949 + _e10286) - 1u) >> bitcast<u32>(_e10284)));
if _e471 {
phi_56347_ = type_26(_e10296, _e10295);
} else {
phi_56347_ = type_26(_e10295, _e10296);
}
let _e10300 = phi_56347_;
let _e10305 = f32((1i << bitcast<u32>(_e10284)));
let _e10306 = (1f / _e10305);
let _e10308 = ((_e9735 * _e10306) - 0.5f);
let _e10310 = ((_e9828 * _e10306) - 0.5f);
let _e10312 = select(-1f, _e10308, (_e10308 > -1f));
let _e10314 = select(1e6f, _e10312, (_e10312 < 1e6f));
let _e10321 = select(0i, select(select(i32(_e10314), i32(-2147483648), (_e10314 < -2147483600f)), 2147483647i, (_e10314 > 2147483500f)), (_e10314 == _e10314));
let _e10325 = (_e10321 - select(0i, 1i, (_e10314 < f32(_e10321))));
let _e10327 = select(-1f, _e10310, (_e10310 > -1f));
let _e10329 = select(1e6f, _e10327, (_e10327 < 1e6f));
let _e10336 = select(0i, select(select(i32(_e10329), i32(-2147483648), (_e10329 < -2147483600f)), 2147483647i, (_e10329 > 2147483500f)), (_e10329 == _e10329));
let _e10340 = (_e10336 - select(0i, 1i, (_e10329 < f32(_e10336))));
let _e10342 = (_e10308 - f32(_e10325));
let _e10344 = (_e10310 - f32(_e10340));
let _e10345 = (1f - _e10342);
let _e10346 = (1f - _e10344);
let _e10349 = select(_e10325, 0i, (_e10325 < 0i));
let _e10350 = (_e10349 >= _e10300.member);
if _e10350 {
phi_56425_ = (_e10300.member - 1i);
} else {
phi_56425_ = _e10349;
}
let _e10353 = phi_56425_;
let _e10355 = select(_e10340, 0i, (_e10340 < 0i));
let _e10356 = (_e10355 >= _e10300.member_1);
if _e10356 {
phi_56436_ = (_e10300.member_1 - 1i);
} else {
phi_56436_ = _e10355;
}
let _e10359 = phi_56436_;
let _e10363 = (((f32(_e10353) + 0.5f) * _e10305) - 0.5f);
let _e10367 = (((f32(_e10359) + 0.5f) * _e10305) - 0.5f);
if _e471 {
phi_56464_ = type_26(_e10359, _e10353);
} else {
phi_56464_ = type_26(_e10353, _e10359);
}
let _e10373 = phi_56464_;
let _e10379 = bitcast<i32>(((_e946 + 1u) >> bitcast<u32>(1u)));
let _e10382 = global_1.member.member_18.member_6;
let _e10385 = global_1.member.member_18.member_7;
let _e10388 = global_1.member.member_18.member_8;
let _e10389 = (_e10283 == 0u);
if _e10389 {
phi_56515_ = 0u;
} else {
if (_e10283 == 1u) {
phi_56514_ = 0u;
} else {
if (_e10283 == 2u) {
phi_56513_ = _e10382;
} else {
phi_56513_ = select(_e10388, _e10385, (_e10283 == 3u));
}
let _e10395 = phi_56513_;
phi_56514_ = _e10395;
}
let _e10397 = phi_56514_;
phi_56515_ = _e10397;
}
let _e10399 = phi_56515_;
local_74 = (((bitcast<i32>(_e10399) + _e10373.member_1) * _e10379) + _e10373.member);
let _e10404 = local_74;
let _e10406 = (bitcast<i32>(_e280) - 1i);
let _e10408 = select(_e10406, _e10404, (_e10404 < _e10406));
let _e10413 = global_6.member[bitcast<u32>(select(0i, _e10408, (_e10408 > 0i)))];
let _e10418 = (((((select(_e10363, _e10367, _e471) + 0.5f) / _e9908) * 2f) - 1f) * _e9916);
let _e10423 = ((1f - (((select(_e10367, _e10363, _e471) + 0.5f) / _e9909) * 2f)) * _e9924);
let _e10430 = ((_e9927.member * _e10418) + (_e9935.member * _e10423));
let _e10431 = ((_e9927.member_1 * _e10418) + (_e9935.member_1 * _e10423));
let _e10432 = ((_e9927.member_2 * _e10418) + (_e9935.member_2 * _e10423));
let _e10436 = select((_e9950.member + _e10430), _e9950.member, _e9948);
let _e10437 = select((_e9950.member_1 + _e10431), _e9950.member_1, _e9948);
let _e10438 = select((_e9950.member_2 + _e10432), _e9950.member_2, _e9948);
let _e10449 = (((_e10436 * _e10436) + (_e10437 * _e10437)) + (_e10438 * _e10438));
let _e10453 = (1f / sqrt(select(0f, _e10449, (_e10449 > 0f))));
let _e10454 = (_e10436 * _e10453);
let _e10455 = (_e10437 * _e10453);
let _e10456 = (_e10438 * _e10453);
let _e10457 = (_e593 - select(_e9961.member, (_e9961.member + _e10430), _e9948));
let _e10458 = (_e605 - select(_e9961.member_1, (_e9961.member_1 + _e10431), _e9948));
let _e10459 = (_e618 - select(_e9961.member_2, (_e9961.member_2 + _e10432), _e9948));
let _e10464 = (((_e10457 * _e10454) + (_e10458 * _e10455)) + (_e10459 * _e10456));
let _e10469 = (((_e10457 * _e631) + (_e10458 * _e644)) + (_e10459 * _e657));
let _e10474 = (((_e10454 * _e631) + (_e10455 * _e644)) + (_e10456 * _e657));
let _e10477 = ((_e10455 * _e657) - (_e10456 * _e644));
let _e10480 = ((_e10456 * _e631) - (_e10454 * _e657));
let _e10483 = ((_e10454 * _e644) - (_e10455 * _e631));
let _e10488 = (((_e10477 * _e10477) + (_e10480 * _e10480)) + (_e10483 * _e10483));
let _e10491 = (1f / select(1e-9f, _e10488, (_e10488 > 1e-9f)));
let _e10494 = ((_e10464 - (_e10474 * _e10469)) * _e10491);
let _e10497 = (((_e10474 * _e10464) - _e10469) * _e10491);
let _e10503 = select(0f, _e10494, (((_e10497 >= 0f) && (_e10497 < _e709)) && (_e10494 > 0f)));
let _e10505 = (_e10353 << bitcast<u32>(_e10284));
let _e10517 = (_e10325 + 1i);
let _e10520 = select(_e10517, 0i, (_e10517 < 0i));
let _e10521 = (_e10520 >= _e10300.member);
if _e10521 {
phi_57499_ = (_e10300.member - 1i);
} else {
phi_57499_ = _e10520;
}
let _e10524 = phi_57499_;
if _e10356 {
phi_57510_ = (_e10300.member_1 - 1i);
} else {
phi_57510_ = _e10355;
}
let _e10527 = phi_57510_;
let _e10531 = (((f32(_e10524) + 0.5f) * _e10305) - 0.5f);
let _e10535 = (((f32(_e10527) + 0.5f) * _e10305) - 0.5f);
if _e471 {
phi_57538_ = type_26(_e10527, _e10524);
} else {
phi_57538_ = type_26(_e10524, _e10527);
}
let _e10541 = phi_57538_;
if _e10389 {
phi_57589_ = 0u;
} else {
if (_e10283 == 1u) {
phi_57588_ = 0u;
} else {
if (_e10283 == 2u) {
phi_57587_ = _e10382;
} else {
phi_57587_ = select(_e10388, _e10385, (_e10283 == 3u));
}
let _e10549 = phi_57587_;
phi_57588_ = _e10549;
}
let _e10551 = phi_57588_;
phi_57589_ = _e10551;
}
let _e10553 = phi_57589_;
local_72 = (((bitcast<i32>(_e10553) + _e10541.member_1) * _e10379) + _e10541.member);
let _e10558 = local_72;
let _e10560 = select(_e10406, _e10558, (_e10558 < _e10406));
let _e10565 = global_6.member[bitcast<u32>(select(0i, _e10560, (_e10560 > 0i)))];
let _e10570 = (((((select(_e10531, _e10535, _e471) + 0.5f) / _e9908) * 2f) - 1f) * _e9916);
let _e10575 = ((1f - (((select(_e10535, _e10531, _e471) + 0.5f) / _e9909) * 2f)) * _e9924);
let _e10582 = ((_e9927.member * _e10570) + (_e9935.member * _e10575));
let _e10583 = ((_e9927.member_1 * _e10570) + (_e9935.member_1 * _e10575));
let _e10584 = ((_e9927.member_2 * _e10570) + (_e9935.member_2 * _e10575));
let _e10588 = select((_e9950.member + _e10582), _e9950.member, _e9948);
let _e10589 = select((_e9950.member_1 + _e10583), _e9950.member_1, _e9948);
let _e10590 = select((_e9950.member_2 + _e10584), _e9950.member_2, _e9948);
let _e10601 = (((_e10588 * _e10588) + (_e10589 * _e10589)) + (_e10590 * _e10590));
let _e10605 = (1f / sqrt(select(0f, _e10601, (_e10601 > 0f))));
let _e10606 = (_e10588 * _e10605);
let _e10607 = (_e10589 * _e10605);
let _e10608 = (_e10590 * _e10605);
let _e10609 = (_e593 - select(_e9961.member, (_e9961.member + _e10582), _e9948));
let _e10610 = (_e605 - select(_e9961.member_1, (_e9961.member_1 + _e10583), _e9948));
let _e10611 = (_e618 - select(_e9961.member_2, (_e9961.member_2 + _e10584), _e9948));
let _e10616 = (((_e10609 * _e10606) + (_e10610 * _e10607)) + (_e10611 * _e10608));
let _e10621 = (((_e10609 * _e631) + (_e10610 * _e644)) + (_e10611 * _e657));
let _e10626 = (((_e10606 * _e631) + (_e10607 * _e644)) + (_e10608 * _e657));
let _e10629 = ((_e10607 * _e657) - (_e10608 * _e644));
let _e10632 = ((_e10608 * _e631) - (_e10606 * _e657));
let _e10635 = ((_e10606 * _e644) - (_e10607 * _e631));
let _e10640 = (((_e10629 * _e10629) + (_e10632 * _e10632)) + (_e10635 * _e10635));
let _e10643 = (1f / select(1e-9f, _e10640, (_e10640 > 1e-9f)));
let _e10646 = ((_e10616 - (_e10626 * _e10621)) * _e10643);
let _e10649 = (((_e10626 * _e10616) - _e10621) * _e10643);
let _e10655 = select(0f, _e10646, (((_e10649 >= 0f) && (_e10649 < _e709)) && (_e10646 > 0f)));
let _e10657 = (_e10524 << bitcast<u32>(_e10284));
let _e10669 = (_e10340 + 1i);
if _e10350 {
phi_58573_ = (_e10300.member - 1i);
} else {
phi_58573_ = _e10349;
}
let _e10673 = phi_58573_;
let _e10675 = select(_e10669, 0i, (_e10669 < 0i));
let _e10676 = (_e10675 >= _e10300.member_1);
if _e10676 {
phi_58584_ = (_e10300.member_1 - 1i);
} else {
phi_58584_ = _e10675;
}
let _e10679 = phi_58584_;
let _e10683 = (((f32(_e10673) + 0.5f) * _e10305) - 0.5f);
let _e10687 = (((f32(_e10679) + 0.5f) * _e10305) - 0.5f);
if _e471 {
phi_58612_ = type_26(_e10679, _e10673);
} else {
phi_58612_ = type_26(_e10673, _e10679);
}
let _e10693 = phi_58612_;
if _e10389 {
phi_58663_ = 0u;
} else {
if (_e10283 == 1u) {
phi_58662_ = 0u;
} else {
if (_e10283 == 2u) {
phi_58661_ = _e10382;
} else {
phi_58661_ = select(_e10388, _e10385, (_e10283 == 3u));
}
let _e10701 = phi_58661_;
phi_58662_ = _e10701;
}
let _e10703 = phi_58662_;
phi_58663_ = _e10703;
}
let _e10705 = phi_58663_;
local_70 = (((bitcast<i32>(_e10705) + _e10693.member_1) * _e10379) + _e10693.member);
let _e10710 = local_70;
let _e10712 = select(_e10406, _e10710, (_e10710 < _e10406));
let _e10717 = global_6.member[bitcast<u32>(select(0i, _e10712, (_e10712 > 0i)))];
let _e10722 = (((((select(_e10683, _e10687, _e471) + 0.5f) / _e9908) * 2f) - 1f) * _e9916);
let _e10727 = ((1f - (((select(_e10687, _e10683, _e471) + 0.5f) / _e9909) * 2f)) * _e9924);
let _e10734 = ((_e9927.member * _e10722) + (_e9935.member * _e10727));
let _e10735 = ((_e9927.member_1 * _e10722) + (_e9935.member_1 * _e10727));
let _e10736 = ((_e9927.member_2 * _e10722) + (_e9935.member_2 * _e10727));
let _e10740 = select((_e9950.member + _e10734), _e9950.member, _e9948);
let _e10741 = select((_e9950.member_1 + _e10735), _e9950.member_1, _e9948);
let _e10742 = select((_e9950.member_2 + _e10736), _e9950.member_2, _e9948);
let _e10753 = (((_e10740 * _e10740) + (_e10741 * _e10741)) + (_e10742 * _e10742));
let _e10757 = (1f / sqrt(select(0f, _e10753, (_e10753 > 0f))));
let _e10758 = (_e10740 * _e10757);
let _e10759 = (_e10741 * _e10757);
let _e10760 = (_e10742 * _e10757);
let _e10761 = (_e593 - select(_e9961.member, (_e9961.member + _e10734), _e9948));
let _e10762 = (_e605 - select(_e9961.member_1, (_e9961.member_1 + _e10735), _e9948));
let _e10763 = (_e618 - select(_e9961.member_2, (_e9961.member_2 + _e10736), _e9948));
let _e10768 = (((_e10761 * _e10758) + (_e10762 * _e10759)) + (_e10763 * _e10760));
let _e10773 = (((_e10761 * _e631) + (_e10762 * _e644)) + (_e10763 * _e657));
let _e10778 = (((_e10758 * _e631) + (_e10759 * _e644)) + (_e10760 * _e657));
let _e10781 = ((_e10759 * _e657) - (_e10760 * _e644));
let _e10784 = ((_e10760 * _e631) - (_e10758 * _e657));
let _e10787 = ((_e10758 * _e644) - (_e10759 * _e631));
let _e10792 = (((_e10781 * _e10781) + (_e10784 * _e10784)) + (_e10787 * _e10787));
let _e10795 = (1f / select(1e-9f, _e10792, (_e10792 > 1e-9f)));
let _e10798 = ((_e10768 - (_e10778 * _e10773)) * _e10795);
let _e10801 = (((_e10778 * _e10768) - _e10773) * _e10795);
let _e10807 = select(0f, _e10798, (((_e10801 >= 0f) && (_e10801 < _e709)) && (_e10798 > 0f)));
let _e10809 = (_e10673 << bitcast<u32>(_e10284));
if _e10521 {
phi_59647_ = (_e10300.member - 1i);
} else {
phi_59647_ = _e10520;
}
let _e10824 = phi_59647_;
if _e10676 {
phi_59658_ = (_e10300.member_1 - 1i);
} else {
phi_59658_ = _e10675;
}
let _e10827 = phi_59658_;
let _e10831 = (((f32(_e10824) + 0.5f) * _e10305) - 0.5f);
let _e10835 = (((f32(_e10827) + 0.5f) * _e10305) - 0.5f);
if _e471 {
phi_59686_ = type_26(_e10827, _e10824);
} else {
phi_59686_ = type_26(_e10824, _e10827);
}
let _e10841 = phi_59686_;
if _e10389 {
phi_59737_ = 0u;
} else {
if (_e10283 == 1u) {
phi_59736_ = 0u;
} else {
if (_e10283 == 2u) {
phi_59735_ = _e10382;
} else {
phi_59735_ = select(_e10388, _e10385, (_e10283 == 3u));
}
let _e10849 = phi_59735_;
phi_59736_ = _e10849;
}
let _e10851 = phi_59736_;
phi_59737_ = _e10851;
}
let _e10853 = phi_59737_;
local_68 = (((bitcast<i32>(_e10853) + _e10841.member_1) * _e10379) + _e10841.member);
let _e10858 = local_68;
let _e10860 = select(_e10406, _e10858, (_e10858 < _e10406));
let _e10865 = global_6.member[bitcast<u32>(select(0i, _e10860, (_e10860 > 0i)))];
let _e10870 = (((((select(_e10831, _e10835, _e471) + 0.5f) / _e9908) * 2f) - 1f) * _e9916);
let _e10875 = ((1f - (((select(_e10835, _e10831, _e471) + 0.5f) / _e9909) * 2f)) * _e9924);
let _e10882 = ((_e9927.member * _e10870) + (_e9935.member * _e10875));
let _e10883 = ((_e9927.member_1 * _e10870) + (_e9935.member_1 * _e10875));
let _e10884 = ((_e9927.member_2 * _e10870) + (_e9935.member_2 * _e10875));
let _e10888 = select((_e9950.member + _e10882), _e9950.member, _e9948);
let _e10889 = select((_e9950.member_1 + _e10883), _e9950.member_1, _e9948);
let _e10890 = select((_e9950.member_2 + _e10884), _e9950.member_2, _e9948);
let _e10901 = (((_e10888 * _e10888) + (_e10889 * _e10889)) + (_e10890 * _e10890));
let _e10905 = (1f / sqrt(select(0f, _e10901, (_e10901 > 0f))));
let _e10906 = (_e10888 * _e10905);
let _e10907 = (_e10889 * _e10905);
let _e10908 = (_e10890 * _e10905);
let _e10909 = (_e593 - select(_e9961.member, (_e9961.member + _e10882), _e9948));
let _e10910 = (_e605 - select(_e9961.member_1, (_e9961.member_1 + _e10883), _e9948));
let _e10911 = (_e618 - select(_e9961.member_2, (_e9961.member_2 + _e10884), _e9948));
let _e10916 = (((_e10909 * _e10906) + (_e10910 * _e10907)) + (_e10911 * _e10908));
let _e10921 = (((_e10909 * _e631) + (_e10910 * _e644)) + (_e10911 * _e657));
let _e10926 = (((_e10906 * _e631) + (_e10907 * _e644)) + (_e10908 * _e657));
let _e10929 = ((_e10907 * _e657) - (_e10908 * _e644));
let _e10932 = ((_e10908 * _e631) - (_e10906 * _e657));
let _e10935 = ((_e10906 * _e644) - (_e10907 * _e631));
let _e10940 = (((_e10929 * _e10929) + (_e10932 * _e10932)) + (_e10935 * _e10935));
let _e10943 = (1f / select(1e-9f, _e10940, (_e10940 > 1e-9f)));
let _e10946 = ((_e10916 - (_e10926 * _e10921)) * _e10943);
let _e10949 = (((_e10926 * _e10916) - _e10921) * _e10943);
let _e10955 = select(0f, _e10946, (((_e10949 >= 0f) && (_e10949 < _e709)) && (_e10946 > 0f)));
let _e10957 = (_e10824 << bitcast<u32>(_e10284));
let _e10969 = select(((((1f - select(0f, (_e10345 * _e10346), (((select(select(_e784, _e941, (_e10505 >= _e710)), _e863, (_e10505 < _e316)) == _e10283) && (_e10503 > 0f)) && (_e10503 < _e10413)))) - select(0f, (_e10342 * _e10346), (((select(select(_e784, _e941, (_e10657 >= _e710)), _e863, (_e10657 < _e316)) == _e10283) && (_e10655 > 0f)) && (_e10655 < _e10565)))) - select(0f, (_e10345 * _e10344), (((select(select(_e784, _e941, (_e10809 >= _e710)), _e863, (_e10809 < _e316)) == _e10283) && (_e10807 > 0f)) && (_e10807 < _e10717)))) - select(0f, (_e10342 * _e10344), (((select(select(_e784, _e941, (_e10957 >= _e710)), _e863, (_e10957 < _e316)) == _e10283) && (_e10955 > 0f)) && (_e10955 < _e10865)))), 1f, _e10389);
if _e471 {
phi_60730_ = type_26(_e9825, _e9733);
} else {
phi_60730_ = type_26(_e9733, _e9825);
}
let _e10984 = phi_60730_;
let _e10987 = (_e9826 && (((_e10281 > 0f) && (_e10281 < _e9905)) && (bitcast<f32>((bitcast<u32>(_e10969) & 2147483647u)) > 1e-6f)));
let _e10990 = global_1.member.member_18.member;
let _e10991 = (((select(_e9851, (1f - _e9851), (_e9836 >= 0f)) - select(_e9870, (1f - _e9870), (_e9855 >= 0f))) * (1f / _e9833)) * _e10990);
let _e10995 = select(0f, (((((_e670 * _e10268.member) * ((1f + (_e10149 * (1f + (_e10149 * (0.5f + (_e10149 * (0.16666667f + (_e10149 * (0.041666668f + (_e10149 * (0.008333334f + (_e10149 * (0.001388889f + (_e10149 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10144 + 127i)) << bitcast<u32>(23i))))) * _e10111) * _e10969) * _e10991), _e10987);
let _e10996 = select(0f, (((((_e683 * _e10268.member_1) * ((1f + (_e10197 * (1f + (_e10197 * (0.5f + (_e10197 * (0.16666667f + (_e10197 * (0.041666668f + (_e10197 * (0.008333334f + (_e10197 * (0.001388889f + (_e10197 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10192 + 127i)) << bitcast<u32>(23i))))) * _e10111) * _e10969) * _e10991), _e10987);
let _e10997 = select(0f, (((((_e696 * _e10268.member_2) * ((1f + (_e10245 * (1f + (_e10245 * (0.5f + (_e10245 * (0.16666667f + (_e10245 * (0.041666668f + (_e10245 * (0.008333334f + (_e10245 * (0.001388889f + (_e10245 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10240 + 127i)) << bitcast<u32>(23i))))) * _e10111) * _e10969) * _e10991), _e10987);
let _e11001 = (bitcast<f32>((bitcast<u32>(_e10995) & 2147483647u)) >= 1073741800f);
let _e11002 = (1f / 1048576f);
let _e11005 = ((_e10995 * select(1f, _e11002, _e11001)) + 0.5f);
let _e11007 = select(-1073741800f, _e11005, (_e11005 > -1073741800f));
let _e11009 = select(1073741800f, _e11007, (_e11007 < 1073741800f));
let _e11016 = select(0i, select(select(i32(_e11009), i32(-2147483648), (_e11009 < -2147483600f)), 2147483647i, (_e11009 > 2147483500f)), (_e11009 == _e11009));
let _e11020 = (_e11016 - select(0i, 1i, (_e11009 < f32(_e11016))));
let _e11021 = select(0i, 20i, _e11001);
let _e11025 = (bitcast<u32>(_e11020) << bitcast<u32>((_e11021 & 31i)));
let _e11032 = bitcast<u32>(((_e11020 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11021) & 31i))));
let _e11036 = (bitcast<f32>((bitcast<u32>(_e10996) & 2147483647u)) >= 1073741800f);
let _e11039 = ((_e10996 * select(1f, _e11002, _e11036)) + 0.5f);
let _e11041 = select(-1073741800f, _e11039, (_e11039 > -1073741800f));
let _e11043 = select(1073741800f, _e11041, (_e11041 < 1073741800f));
let _e11050 = select(0i, select(select(i32(_e11043), i32(-2147483648), (_e11043 < -2147483600f)), 2147483647i, (_e11043 > 2147483500f)), (_e11043 == _e11043));
let _e11054 = (_e11050 - select(0i, 1i, (_e11043 < f32(_e11050))));
let _e11055 = select(0i, 20i, _e11036);
let _e11059 = (bitcast<u32>(_e11054) << bitcast<u32>((_e11055 & 31i)));
let _e11066 = bitcast<u32>(((_e11054 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11055) & 31i))));
let _e11070 = (bitcast<f32>((bitcast<u32>(_e10997) & 2147483647u)) >= 1073741800f);
let _e11073 = ((_e10997 * select(1f, _e11002, _e11070)) + 0.5f);
let _e11075 = select(-1073741800f, _e11073, (_e11073 > -1073741800f));
let _e11077 = select(1073741800f, _e11075, (_e11075 < 1073741800f));
let _e11084 = select(0i, select(select(i32(_e11077), i32(-2147483648), (_e11077 < -2147483600f)), 2147483647i, (_e11077 > 2147483500f)), (_e11077 == _e11077));
let _e11088 = (_e11084 - select(0i, 1i, (_e11077 < f32(_e11084))));
let _e11089 = select(0i, 20i, _e11070);
let _e11093 = (bitcast<u32>(_e11088) << bitcast<u32>((_e11089 & 31i)));
let _e11100 = bitcast<u32>(((_e11088 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11089) & 31i))));
let _e11105 = bitcast<i32>(bitcast<u32>((((_e10984.member_1 * _e950) + _e10984.member) * 6i)));
if ((_e11025 | _e11032) == 0u) {
} else {
let _e11108 = bitcast<u32>(_e11105);
if (_e11108 < _e288) {
let _e11112 = atomicAdd((&global_8.member[_e11108]), _e11025);
phi_60963_ = _e11112;
} else {
phi_60963_ = 0u;
}
let _e11114 = phi_60963_;
let _e11118 = (_e11032 + select(0u, 1u, ((_e11114 + _e11025) < _e11025)));
if (_e11118 == 0u) {
} else {
let _e11120 = (_e11108 + 1u);
if (_e11120 < _e288) {
let _e11124 = atomicAdd((&global_8.member[_e11120]), _e11118);
}
}
}
if ((_e11059 | _e11066) == 0u) {
} else {
let _e11128 = bitcast<u32>((_e11105 + 2i));
if (_e11128 < _e288) {
let _e11132 = atomicAdd((&global_8.member[_e11128]), _e11059);
phi_60993_ = _e11132;
} else {
phi_60993_ = 0u;
}
let _e11134 = phi_60993_;
let _e11138 = (_e11066 + select(0u, 1u, ((_e11134 + _e11059) < _e11059)));
if (_e11138 == 0u) {
} else {
let _e11140 = (_e11128 + 1u);
if (_e11140 < _e288) {
let _e11144 = atomicAdd((&global_8.member[_e11140]), _e11138);
}
}
}
if ((_e11093 | _e11100) == 0u) {
} else {
let _e11148 = bitcast<u32>((_e11105 + 4i));
if (_e11148 < _e288) {
let _e11152 = atomicAdd((&global_8.member[_e11148]), _e11093);
phi_61023_ = _e11152;
} else {
phi_61023_ = 0u;
}
let _e11154 = phi_61023_;
let _e11158 = (_e11100 + select(0u, 1u, ((_e11154 + _e11093) < _e11093)));
if (_e11158 == 0u) {
} else {
let _e11160 = (_e11148 + 1u);
if (_e11160 < _e288) {
let _e11164 = atomicAdd((&global_8.member[_e11160]), _e11158);
}
}
}
phi_55188_ = (_e9823 + 1i);
} else {
phi_55188_ = i32();
}
let _e11167 = phi_55188_;
continue;
continuing {
phi_55187_ = _e11167;
break if !(_e9826);
}
}
phi_55034_ = (_e9730 + 1i);
} else {
phi_55034_ = i32();
}
let _e11171 = phi_55034_;
continue;
continuing {
phi_55033_ = _e11171;
break if !(_e9731);
}
}
} else {
phi_61068_ = 0i;
loop {
let _e6947 = phi_61068_;
let _e6948 = (_e6947 < 16i);
if _e6948 {
let _e6950 = (_e995 + (_e6947 & 15i));
let _e6952 = (f32(_e6950) + 0.5f);
let _e6954 = ((_e6952 * 1f) - 0.5f);
let _e6958 = (-(((_e434 * _e6954) + _e460)) / _e447);
let _e6965 = bitcast<f32>((bitcast<u32>(((_e484 * _e6954) + ((_e497 * _e6958) + _e510))) & 2147483647u));
let _e6972 = bitcast<f32>((bitcast<u32>(((_e523 * _e6954) + ((_e536 * _e6958) + _e549))) & 2147483647u));
let _e6976 = (((0.5f * (_e6965 + _e6972)) / _e552) + _e735);
let _e6977 = (1f / 1f);
let _e6985 = ((((_e6958 + _e6976) + 0.5f) * _e6977) - 0.5f);
let _e6986 = f32(_e1000);
let _e6987 = (0f - 1f);
let _e6989 = select(_e6987, _e6985, (_e6985 > _e6987));
let _e6991 = select(_e6986, _e6989, (_e6989 < _e6986));
let _e6998 = select(0i, select(select(i32(_e6991), i32(-2147483648), (_e6991 < -2147483600f)), 2147483647i, (_e6991 > 2147483500f)), (_e6991 == _e6991));
let _e7003 = (((((_e6958 - _e6976) + 0.5f) * _e6977) - 0.5f) + 1f);
let _e7004 = (_e6986 + 1f);
let _e7006 = select(0f, _e7003, (_e7003 > 0f));
let _e7008 = select(_e7004, _e7006, (_e7006 < _e7004));
let _e7015 = select(0i, select(select(i32(_e7008), i32(-2147483648), (_e7008 < -2147483600f)), 2147483647i, (_e7008 > 2147483500f)), (_e7008 == _e7008));
let _e7026 = ((1e-4f * 1f) * _e552);
let _e7028 = select(_e6972, _e6965, (_e6965 > _e6972));
let _e7030 = select(_e7026, _e7028, (_e7028 > _e7026));
let _e7032 = select(_e6972, _e6965, (_e6965 < _e6972));
let _e7034 = select(_e7026, _e7032, (_e7032 > _e7026));
let _e7036 = (0.5f * (_e7030 + _e7034));
let _e7037 = (0.5f / _e7034);
let _e7038 = (1f / _e7030);
phi_61222_ = 0i;
loop {
let _e7040 = phi_61222_;
let _e7042 = (((_e7015 - select(0i, 1i, (_e7008 < f32(_e7015)))) + (_e6947 >> bitcast<u32>(4u))) + bitcast<i32>(_e7040));
let _e7043 = (_e7042 <= select(-1i, (_e6998 - select(0i, 1i, (_e6991 < f32(_e6998)))), (_e6950 <= _e999)));
if _e7043 {
let _e7045 = (f32(_e7042) + 0.5f);
let _e7049 = ((((_e7045 * 1f) - 0.5f) - _e6958) * _e552);
let _e7050 = (_e552 * 1f);
let _e7052 = (0.5f * _e7050);
let _e7053 = (_e7049 + _e7052);
let _e7054 = -(_e7053);
let _e7057 = (_e7036 - select(_e7054, _e7053, (_e7053 > _e7054)));
let _e7059 = select(0f, _e7057, (_e7057 > 0f));
let _e7061 = select(_e7034, _e7059, (_e7059 < _e7034));
let _e7064 = (_e7057 - _e7034);
let _e7068 = (((_e7061 * (_e7061 * _e7037)) + select(0f, _e7064, (_e7064 > 0f))) * _e7038);
let _e7072 = (_e7049 - _e7052);
let _e7073 = -(_e7072);
let _e7076 = (_e7036 - select(_e7073, _e7072, (_e7072 > _e7073)));
let _e7078 = select(0f, _e7076, (_e7076 > 0f));
let _e7080 = select(_e7034, _e7078, (_e7078 < _e7034));
let _e7083 = (_e7076 - _e7034);
let _e7087 = (((_e7080 * (_e7080 * _e7037)) + select(0f, _e7083, (_e7083 > 0f))) * _e7038);
if _e471 {
phi_61327_ = type_26(_e7042, _e6950);
} else {
phi_61327_ = type_26(_e6950, _e7042);
}
let _e7096 = phi_61327_;
local_66 = bitcast<i32>((_e946 * _e949));
local_67 = ((_e7096.member_1 * _e950) + _e7096.member);
let _e7103 = local_66;
let _e7104 = local_67;
let _e7105 = (_e7103 + _e7104);
let _e7107 = (bitcast<i32>(_e277) - 1i);
let _e7109 = select(_e7107, _e7105, (_e7105 < _e7107));
let _e7114 = global_5.member[bitcast<u32>(select(0i, _e7109, (_e7109 > 0i)))];
let _e7115 = local_67;
let _e7117 = select(_e7107, _e7115, (_e7115 < _e7107));
let _e7122 = global_5.member[bitcast<u32>(select(0i, _e7117, (_e7117 > 0i)))];
let _e7125 = f32(_e950);
let _e7126 = f32(_e951);
let _e7133 = global_1.member.member_2.member;
let _e7134 = (((((f32(_e7096.member) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e7141 = global_1.member.member_2.member_1;
let _e7142 = ((1f - (((f32(_e7096.member_1) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e7144 = global_1.member.member_3;
let _e7152 = global_1.member.member_4;
let _e7159 = ((_e7144.member * _e7134) + (_e7152.member * _e7142));
let _e7160 = ((_e7144.member_1 * _e7134) + (_e7152.member_1 * _e7142));
let _e7161 = ((_e7144.member_2 * _e7134) + (_e7152.member_2 * _e7142));
let _e7164 = global_1.member.member_2.member_3;
let _e7165 = (_e7164 != 0u);
let _e7167 = global_1.member.member_5;
let _e7174 = select((_e7167.member + _e7159), _e7167.member, _e7165);
let _e7175 = select((_e7167.member_1 + _e7160), _e7167.member_1, _e7165);
let _e7176 = select((_e7167.member_2 + _e7161), _e7167.member_2, _e7165);
let _e7178 = global_1.member.member_6;
let _e7192 = (((_e7174 * _e7174) + (_e7175 * _e7175)) + (_e7176 * _e7176));
let _e7195 = sqrt(select(0f, _e7192, (_e7192 > 0f)));
let _e7196 = (1f / _e7195);
let _e7197 = (_e7174 * _e7196);
let _e7198 = (_e7175 * _e7196);
let _e7199 = (_e7176 * _e7196);
let _e7200 = (_e593 - select(_e7178.member, (_e7178.member + _e7159), _e7165));
let _e7201 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e7160), _e7165));
let _e7202 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e7161), _e7165));
let _e7207 = (((_e7200 * _e7197) + (_e7201 * _e7198)) + (_e7202 * _e7199));
let _e7212 = (((_e7200 * _e631) + (_e7201 * _e644)) + (_e7202 * _e657));
let _e7217 = (((_e7197 * _e631) + (_e7198 * _e644)) + (_e7199 * _e657));
let _e7220 = ((_e7198 * _e657) - (_e7199 * _e644));
let _e7223 = ((_e7199 * _e631) - (_e7197 * _e657));
let _e7226 = ((_e7197 * _e644) - (_e7198 * _e631));
let _e7231 = (((_e7220 * _e7220) + (_e7223 * _e7223)) + (_e7226 * _e7226));
let _e7234 = (1f / select(1e-9f, _e7231, (_e7231 > 1e-9f)));
let _e7237 = ((_e7207 - (_e7217 * _e7212)) * _e7234);
let _e7240 = (((_e7217 * _e7207) - _e7212) * _e7234);
let _e7246 = -(_e7217);
let _e7249 = global_1.member.member_13.member_2;
let _e7250 = (_e7249 * _e7249);
let _e7254 = ((1f + _e7250) - ((2f * _e7249) * _e7246));
let _e7256 = select(1e-9f, _e7254, (_e7254 > 1e-9f));
let _e7268 = global_1.member.member_13.member_3;
if (_e7268 == 2u) {
let _e7273 = (0.5f - (0.5f * _e7246));
let _e7275 = select(0f, _e7273, (_e7273 > 0f));
let _e7279 = (sqrt(select(0f, _e7275, (_e7275 > 0f))) * 255f);
let _e7280 = (255f - 1f);
let _e7282 = select(0f, _e7279, (_e7279 > 0f));
let _e7284 = select(_e7280, _e7282, (_e7282 < _e7280));
let _e7291 = select(0i, select(select(i32(_e7284), i32(-2147483648), (_e7284 < -2147483600f)), 2147483647i, (_e7284 > 2147483500f)), (_e7284 == _e7284));
let _e7295 = (_e7291 - select(0i, 1i, (_e7284 < f32(_e7291))));
let _e7298 = global_1.member.member_13.member_11;
let _e7299 = bitcast<i32>(_e7298);
let _e7300 = (_e7299 + _e7295);
let _e7302 = (bitcast<i32>(_e283) - 1i);
let _e7304 = select(_e7302, _e7300, (_e7300 < _e7302));
let _e7309 = global_2.member[bitcast<u32>(select(0i, _e7304, (_e7304 > 0i)))];
let _e7311 = (_e7299 + (_e7295 + 1i));
let _e7313 = select(_e7302, _e7311, (_e7311 < _e7302));
let _e7318 = global_2.member[bitcast<u32>(select(0i, _e7313, (_e7313 > 0i)))];
phi_61754_ = (_e7309 + ((_e7318 - _e7309) * (_e7279 - f32(_e7295))));
} else {
phi_61754_ = select(((1f - _e7250) / (_e7256 * sqrt(select(0f, _e7256, (_e7256 > 0f))))), (0.75f * (1f + (_e7246 * _e7246))), (_e7268 == 1u));
}
let _e7325 = phi_61754_;
let _e7328 = (_e7195 * (_e7325 * (0.25f / 3.1415927f)));
let _e7329 = (_e7237 - _e7114);
let _e7332 = (_e7240 + select(0f, _e7329, (_e7329 > 0f)));
let _e7335 = global_1.member.member_13.member;
let _e7340 = -((_e7335.member * _e7332));
let _e7342 = select(-87f, _e7340, (_e7340 > -87f));
let _e7344 = select(88f, _e7342, (_e7342 < 88f));
let _e7346 = ((_e7344 * 1.442695f) + 0.5f);
let _e7348 = select(-127f, _e7346, (_e7346 > -127f));
let _e7350 = select(128f, _e7348, (_e7348 < 128f));
let _e7357 = select(0i, select(select(i32(_e7350), i32(-2147483648), (_e7350 < -2147483600f)), 2147483647i, (_e7350 > 2147483500f)), (_e7350 == _e7350));
let _e7361 = (_e7357 - select(0i, 1i, (_e7350 < f32(_e7357))));
let _e7362 = f32(_e7361);
let _e7366 = ((_e7344 - (_e7362 * 0.6933594f)) - (_e7362 * -2.1219444e-4f));
let _e7388 = -((_e7335.member_1 * _e7332));
let _e7390 = select(-87f, _e7388, (_e7388 > -87f));
let _e7392 = select(88f, _e7390, (_e7390 < 88f));
let _e7394 = ((_e7392 * 1.442695f) + 0.5f);
let _e7396 = select(-127f, _e7394, (_e7394 > -127f));
let _e7398 = select(128f, _e7396, (_e7396 < 128f));
let _e7405 = select(0i, select(select(i32(_e7398), i32(-2147483648), (_e7398 < -2147483600f)), 2147483647i, (_e7398 > 2147483500f)), (_e7398 == _e7398));
let _e7409 = (_e7405 - select(0i, 1i, (_e7398 < f32(_e7405))));
let _e7410 = f32(_e7409);
let _e7414 = ((_e7392 - (_e7410 * 0.6933594f)) - (_e7410 * -2.1219444e-4f));
let _e7436 = -((_e7335.member_2 * _e7332));
let _e7438 = select(-87f, _e7436, (_e7436 > -87f));
let _e7440 = select(88f, _e7438, (_e7438 < 88f));
let _e7442 = ((_e7440 * 1.442695f) + 0.5f);
let _e7444 = select(-127f, _e7442, (_e7442 > -127f));
let _e7446 = select(128f, _e7444, (_e7444 < 128f));
let _e7453 = select(0i, select(select(i32(_e7446), i32(-2147483648), (_e7446 < -2147483600f)), 2147483647i, (_e7446 > 2147483500f)), (_e7446 == _e7446));
let _e7457 = (_e7453 - select(0i, 1i, (_e7446 < f32(_e7453))));
let _e7458 = f32(_e7457);
let _e7462 = ((_e7440 - (_e7458 * 0.6933594f)) - (_e7458 * -2.1219444e-4f));
let _e7485 = global_1.member.member_13.member_1;
let _e7498 = select(0f, _e7237, (((_e7240 >= 0f) && (_e7240 < _e709)) && (_e7237 > 0f)));
let _e7499 = (_e784 & 31u);
let _e7501 = (1u << bitcast<u32>(_e7499));
let _e7510 = bitcast<i32>((((_e946 + _e7501) - 1u) >> bitcast<u32>(_e7499)));
let _e7511 = bitcast<i32>((((_e949 + _e7501) - 1u) >> bitcast<u32>(_e7499)));
if _e471 {
phi_62380_ = type_26(_e7511, _e7510);
} else {
phi_62380_ = type_26(_e7510, _e7511);
}
let _e7515 = phi_62380_;
let _e7520 = f32((1i << bitcast<u32>(_e7499)));
let _e7521 = (1f / _e7520);
let _e7523 = ((_e6952 * _e7521) - 0.5f);
let _e7525 = ((_e7045 * _e7521) - 0.5f);
let _e7527 = select(-1f, _e7523, (_e7523 > -1f));
let _e7529 = select(1e6f, _e7527, (_e7527 < 1e6f));
let _e7536 = select(0i, select(select(i32(_e7529), i32(-2147483648), (_e7529 < -2147483600f)), 2147483647i, (_e7529 > 2147483500f)), (_e7529 == _e7529));
let _e7540 = (_e7536 - select(0i, 1i, (_e7529 < f32(_e7536))));
let _e7542 = select(-1f, _e7525, (_e7525 > -1f));
let _e7544 = select(1e6f, _e7542, (_e7542 < 1e6f));
let _e7551 = select(0i, select(select(i32(_e7544), i32(-2147483648), (_e7544 < -2147483600f)), 2147483647i, (_e7544 > 2147483500f)), (_e7544 == _e7544));
let _e7555 = (_e7551 - select(0i, 1i, (_e7544 < f32(_e7551))));
let _e7557 = (_e7523 - f32(_e7540));
let _e7559 = (_e7525 - f32(_e7555));
let _e7560 = (1f - _e7557);
let _e7561 = (1f - _e7559);
let _e7564 = select(_e7540, 0i, (_e7540 < 0i));
let _e7565 = (_e7564 >= _e7515.member);
if _e7565 {
phi_62458_ = (_e7515.member - 1i);
} else {
phi_62458_ = _e7564;
}
let _e7568 = phi_62458_;
let _e7570 = select(_e7555, 0i, (_e7555 < 0i));
let _e7571 = (_e7570 >= _e7515.member_1);
if _e7571 {
phi_62469_ = (_e7515.member_1 - 1i);
} else {
phi_62469_ = _e7570;
}
let _e7574 = phi_62469_;
let _e7578 = (((f32(_e7568) + 0.5f) * _e7520) - 0.5f);
let _e7582 = (((f32(_e7574) + 0.5f) * _e7520) - 0.5f);
if _e471 {
phi_62497_ = type_26(_e7574, _e7568);
} else {
phi_62497_ = type_26(_e7568, _e7574);
}
let _e7588 = phi_62497_;
let _e7594 = bitcast<i32>(((_e946 + 1u) >> bitcast<u32>(1u)));
let _e7597 = global_1.member.member_18.member_6;
let _e7600 = global_1.member.member_18.member_7;
let _e7603 = global_1.member.member_18.member_8;
if _e1001 {
phi_62548_ = 0u;
} else {
if (_e784 == 1u) {
phi_62547_ = 0u;
} else {
if (_e784 == 2u) {
phi_62546_ = _e7597;
} else {
phi_62546_ = select(_e7603, _e7600, (_e784 == 3u));
}
let _e7609 = phi_62546_;
phi_62547_ = _e7609;
}
let _e7611 = phi_62547_;
phi_62548_ = _e7611;
}
let _e7613 = phi_62548_;
local_64 = (((bitcast<i32>(_e7613) + _e7588.member_1) * _e7594) + _e7588.member);
let _e7618 = local_64;
let _e7620 = (bitcast<i32>(_e280) - 1i);
let _e7622 = select(_e7620, _e7618, (_e7618 < _e7620));
let _e7627 = global_6.member[bitcast<u32>(select(0i, _e7622, (_e7622 > 0i)))];
let _e7632 = (((((select(_e7578, _e7582, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e7637 = ((1f - (((select(_e7582, _e7578, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e7644 = ((_e7144.member * _e7632) + (_e7152.member * _e7637));
let _e7645 = ((_e7144.member_1 * _e7632) + (_e7152.member_1 * _e7637));
let _e7646 = ((_e7144.member_2 * _e7632) + (_e7152.member_2 * _e7637));
let _e7650 = select((_e7167.member + _e7644), _e7167.member, _e7165);
let _e7651 = select((_e7167.member_1 + _e7645), _e7167.member_1, _e7165);
let _e7652 = select((_e7167.member_2 + _e7646), _e7167.member_2, _e7165);
let _e7663 = (((_e7650 * _e7650) + (_e7651 * _e7651)) + (_e7652 * _e7652));
let _e7667 = (1f / sqrt(select(0f, _e7663, (_e7663 > 0f))));
let _e7668 = (_e7650 * _e7667);
let _e7669 = (_e7651 * _e7667);
let _e7670 = (_e7652 * _e7667);
let _e7671 = (_e593 - select(_e7178.member, (_e7178.member + _e7644), _e7165));
let _e7672 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e7645), _e7165));
let _e7673 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e7646), _e7165));
let _e7678 = (((_e7671 * _e7668) + (_e7672 * _e7669)) + (_e7673 * _e7670));
let _e7683 = (((_e7671 * _e631) + (_e7672 * _e644)) + (_e7673 * _e657));
let _e7688 = (((_e7668 * _e631) + (_e7669 * _e644)) + (_e7670 * _e657));
let _e7691 = ((_e7669 * _e657) - (_e7670 * _e644));
let _e7694 = ((_e7670 * _e631) - (_e7668 * _e657));
let _e7697 = ((_e7668 * _e644) - (_e7669 * _e631));
let _e7702 = (((_e7691 * _e7691) + (_e7694 * _e7694)) + (_e7697 * _e7697));
let _e7705 = (1f / select(1e-9f, _e7702, (_e7702 > 1e-9f)));
let _e7708 = ((_e7678 - (_e7688 * _e7683)) * _e7705);
let _e7711 = (((_e7688 * _e7678) - _e7683) * _e7705);
let _e7717 = select(0f, _e7708, (((_e7711 >= 0f) && (_e7711 < _e709)) && (_e7708 > 0f)));
let _e7719 = (_e7568 << bitcast<u32>(_e7499));
let _e7731 = (_e7540 + 1i);
let _e7734 = select(_e7731, 0i, (_e7731 < 0i));
let _e7735 = (_e7734 >= _e7515.member);
if _e7735 {
phi_63532_ = (_e7515.member - 1i);
} else {
phi_63532_ = _e7734;
}
let _e7738 = phi_63532_;
if _e7571 {
phi_63543_ = (_e7515.member_1 - 1i);
} else {
phi_63543_ = _e7570;
}
let _e7741 = phi_63543_;
let _e7745 = (((f32(_e7738) + 0.5f) * _e7520) - 0.5f);
let _e7749 = (((f32(_e7741) + 0.5f) * _e7520) - 0.5f);
if _e471 {
phi_63571_ = type_26(_e7741, _e7738);
} else {
phi_63571_ = type_26(_e7738, _e7741);
}
let _e7755 = phi_63571_;
if _e1001 {
phi_63622_ = 0u;
} else {
if (_e784 == 1u) {
phi_63621_ = 0u;
} else {
if (_e784 == 2u) {
phi_63620_ = _e7597;
} else {
phi_63620_ = select(_e7603, _e7600, (_e784 == 3u));
}
let _e7763 = phi_63620_;
phi_63621_ = _e7763;
}
let _e7765 = phi_63621_;
phi_63622_ = _e7765;
}
let _e7767 = phi_63622_;
local_62 = (((bitcast<i32>(_e7767) + _e7755.member_1) * _e7594) + _e7755.member);
let _e7772 = local_62;
let _e7774 = select(_e7620, _e7772, (_e7772 < _e7620));
let _e7779 = global_6.member[bitcast<u32>(select(0i, _e7774, (_e7774 > 0i)))];
let _e7784 = (((((select(_e7745, _e7749, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e7789 = ((1f - (((select(_e7749, _e7745, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e7796 = ((_e7144.member * _e7784) + (_e7152.member * _e7789));
let _e7797 = ((_e7144.member_1 * _e7784) + (_e7152.member_1 * _e7789));
let _e7798 = ((_e7144.member_2 * _e7784) + (_e7152.member_2 * _e7789));
let _e7802 = select((_e7167.member + _e7796), _e7167.member, _e7165);
let _e7803 = select((_e7167.member_1 + _e7797), _e7167.member_1, _e7165);
let _e7804 = select((_e7167.member_2 + _e7798), _e7167.member_2, _e7165);
let _e7815 = (((_e7802 * _e7802) + (_e7803 * _e7803)) + (_e7804 * _e7804));
let _e7819 = (1f / sqrt(select(0f, _e7815, (_e7815 > 0f))));
let _e7820 = (_e7802 * _e7819);
let _e7821 = (_e7803 * _e7819);
let _e7822 = (_e7804 * _e7819);
let _e7823 = (_e593 - select(_e7178.member, (_e7178.member + _e7796), _e7165));
let _e7824 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e7797), _e7165));
let _e7825 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e7798), _e7165));
let _e7830 = (((_e7823 * _e7820) + (_e7824 * _e7821)) + (_e7825 * _e7822));
let _e7835 = (((_e7823 * _e631) + (_e7824 * _e644)) + (_e7825 * _e657));
let _e7840 = (((_e7820 * _e631) + (_e7821 * _e644)) + (_e7822 * _e657));
let _e7843 = ((_e7821 * _e657) - (_e7822 * _e644));
let _e7846 = ((_e7822 * _e631) - (_e7820 * _e657));
let _e7849 = ((_e7820 * _e644) - (_e7821 * _e631));
let _e7854 = (((_e7843 * _e7843) + (_e7846 * _e7846)) + (_e7849 * _e7849));
let _e7857 = (1f / select(1e-9f, _e7854, (_e7854 > 1e-9f)));
let _e7860 = ((_e7830 - (_e7840 * _e7835)) * _e7857);
let _e7863 = (((_e7840 * _e7830) - _e7835) * _e7857);
let _e7869 = select(0f, _e7860, (((_e7863 >= 0f) && (_e7863 < _e709)) && (_e7860 > 0f)));
let _e7871 = (_e7738 << bitcast<u32>(_e7499));
let _e7883 = (_e7555 + 1i);
if _e7565 {
phi_64606_ = (_e7515.member - 1i);
} else {
phi_64606_ = _e7564;
}
let _e7887 = phi_64606_;
let _e7889 = select(_e7883, 0i, (_e7883 < 0i));
let _e7890 = (_e7889 >= _e7515.member_1);
if _e7890 {
phi_64617_ = (_e7515.member_1 - 1i);
} else {
phi_64617_ = _e7889;
}
let _e7893 = phi_64617_;
let _e7897 = (((f32(_e7887) + 0.5f) * _e7520) - 0.5f);
let _e7901 = (((f32(_e7893) + 0.5f) * _e7520) - 0.5f);
if _e471 {
phi_64645_ = type_26(_e7893, _e7887);
} else {
phi_64645_ = type_26(_e7887, _e7893);
}
let _e7907 = phi_64645_;
if _e1001 {
phi_64696_ = 0u;
} else {
if (_e784 == 1u) {
phi_64695_ = 0u;
} else {
if (_e784 == 2u) {
phi_64694_ = _e7597;
} else {
phi_64694_ = select(_e7603, _e7600, (_e784 == 3u));
}
let _e7915 = phi_64694_;
phi_64695_ = _e7915;
}
let _e7917 = phi_64695_;
phi_64696_ = _e7917;
}
let _e7919 = phi_64696_;
local_60 = (((bitcast<i32>(_e7919) + _e7907.member_1) * _e7594) + _e7907.member);
let _e7924 = local_60;
let _e7926 = select(_e7620, _e7924, (_e7924 < _e7620));
let _e7931 = global_6.member[bitcast<u32>(select(0i, _e7926, (_e7926 > 0i)))];
let _e7936 = (((((select(_e7897, _e7901, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e7941 = ((1f - (((select(_e7901, _e7897, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e7948 = ((_e7144.member * _e7936) + (_e7152.member * _e7941));
let _e7949 = ((_e7144.member_1 * _e7936) + (_e7152.member_1 * _e7941));
let _e7950 = ((_e7144.member_2 * _e7936) + (_e7152.member_2 * _e7941));
let _e7954 = select((_e7167.member + _e7948), _e7167.member, _e7165);
let _e7955 = select((_e7167.member_1 + _e7949), _e7167.member_1, _e7165);
let _e7956 = select((_e7167.member_2 + _e7950), _e7167.member_2, _e7165);
let _e7967 = (((_e7954 * _e7954) + (_e7955 * _e7955)) + (_e7956 * _e7956));
let _e7971 = (1f / sqrt(select(0f, _e7967, (_e7967 > 0f))));
let _e7972 = (_e7954 * _e7971);
let _e7973 = (_e7955 * _e7971);
let _e7974 = (_e7956 * _e7971);
let _e7975 = (_e593 - select(_e7178.member, (_e7178.member + _e7948), _e7165));
let _e7976 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e7949), _e7165));
let _e7977 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e7950), _e7165));
let _e7982 = (((_e7975 * _e7972) + (_e7976 * _e7973)) + (_e7977 * _e7974));
let _e7987 = (((_e7975 * _e631) + (_e7976 * _e644)) + (_e7977 * _e657));
let _e7992 = (((_e7972 * _e631) + (_e7973 * _e644)) + (_e7974 * _e657));
let _e7995 = ((_e7973 * _e657) - (_e7974 * _e644));
let _e7998 = ((_e7974 * _e631) - (_e7972 * _e657));
let _e8001 = ((_e7972 * _e644) - (_e7973 * _e631));
let _e8006 = (((_e7995 * _e7995) + (_e7998 * _e7998)) + (_e8001 * _e8001));
let _e8009 = (1f / select(1e-9f, _e8006, (_e8006 > 1e-9f)));
let _e8012 = ((_e7982 - (_e7992 * _e7987)) * _e8009);
let _e8015 = (((_e7992 * _e7982) - _e7987) * _e8009);
let _e8021 = select(0f, _e8012, (((_e8015 >= 0f) && (_e8015 < _e709)) && (_e8012 > 0f)));
let _e8023 = (_e7887 << bitcast<u32>(_e7499));
if _e7735 {
phi_65680_ = (_e7515.member - 1i);
} else {
phi_65680_ = _e7734;
}
let _e8038 = phi_65680_;
if _e7890 {
phi_65691_ = (_e7515.member_1 - 1i);
} else {
phi_65691_ = _e7889;
}
let _e8041 = phi_65691_;
let _e8045 = (((f32(_e8038) + 0.5f) * _e7520) - 0.5f);
let _e8049 = (((f32(_e8041) + 0.5f) * _e7520) - 0.5f);
if _e471 {
phi_65719_ = type_26(_e8041, _e8038);
} else {
phi_65719_ = type_26(_e8038, _e8041);
}
let _e8055 = phi_65719_;
if _e1001 {
phi_65770_ = 0u;
} else {
if (_e784 == 1u) {
phi_65769_ = 0u;
} else {
if (_e784 == 2u) {
phi_65768_ = _e7597;
} else {
phi_65768_ = select(_e7603, _e7600, (_e784 == 3u));
}
let _e8063 = phi_65768_;
phi_65769_ = _e8063;
}
let _e8065 = phi_65769_;
phi_65770_ = _e8065;
}
let _e8067 = phi_65770_;
local_58 = (((bitcast<i32>(_e8067) + _e8055.member_1) * _e7594) + _e8055.member);
let _e8072 = local_58;
let _e8074 = select(_e7620, _e8072, (_e8072 < _e7620));
let _e8079 = global_6.member[bitcast<u32>(select(0i, _e8074, (_e8074 > 0i)))];
let _e8084 = (((((select(_e8045, _e8049, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e8089 = ((1f - (((select(_e8049, _e8045, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e8096 = ((_e7144.member * _e8084) + (_e7152.member * _e8089));
let _e8097 = ((_e7144.member_1 * _e8084) + (_e7152.member_1 * _e8089));
let _e8098 = ((_e7144.member_2 * _e8084) + (_e7152.member_2 * _e8089));
let _e8102 = select((_e7167.member + _e8096), _e7167.member, _e7165);
let _e8103 = select((_e7167.member_1 + _e8097), _e7167.member_1, _e7165);
let _e8104 = select((_e7167.member_2 + _e8098), _e7167.member_2, _e7165);
let _e8115 = (((_e8102 * _e8102) + (_e8103 * _e8103)) + (_e8104 * _e8104));
let _e8119 = (1f / sqrt(select(0f, _e8115, (_e8115 > 0f))));
let _e8120 = (_e8102 * _e8119);
let _e8121 = (_e8103 * _e8119);
let _e8122 = (_e8104 * _e8119);
let _e8123 = (_e593 - select(_e7178.member, (_e7178.member + _e8096), _e7165));
let _e8124 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e8097), _e7165));
let _e8125 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e8098), _e7165));
let _e8130 = (((_e8123 * _e8120) + (_e8124 * _e8121)) + (_e8125 * _e8122));
let _e8135 = (((_e8123 * _e631) + (_e8124 * _e644)) + (_e8125 * _e657));
let _e8140 = (((_e8120 * _e631) + (_e8121 * _e644)) + (_e8122 * _e657));
let _e8143 = ((_e8121 * _e657) - (_e8122 * _e644));
let _e8146 = ((_e8122 * _e631) - (_e8120 * _e657));
let _e8149 = ((_e8120 * _e644) - (_e8121 * _e631));
let _e8154 = (((_e8143 * _e8143) + (_e8146 * _e8146)) + (_e8149 * _e8149));
let _e8157 = (1f / select(1e-9f, _e8154, (_e8154 > 1e-9f)));
let _e8160 = ((_e8130 - (_e8140 * _e8135)) * _e8157);
let _e8163 = (((_e8140 * _e8130) - _e8135) * _e8157);
let _e8169 = select(0f, _e8160, (((_e8163 >= 0f) && (_e8163 < _e709)) && (_e8160 > 0f)));
let _e8171 = (_e8038 << bitcast<u32>(_e7499));
let _e8183 = select(((((1f - select(0f, (_e7560 * _e7561), (((select(select(_e784, _e941, (_e7719 >= _e710)), _e863, (_e7719 < _e316)) == _e784) && (_e7717 > 0f)) && (_e7717 < _e7627)))) - select(0f, (_e7557 * _e7561), (((select(select(_e784, _e941, (_e7871 >= _e710)), _e863, (_e7871 < _e316)) == _e784) && (_e7869 > 0f)) && (_e7869 < _e7779)))) - select(0f, (_e7560 * _e7559), (((select(select(_e784, _e941, (_e8023 >= _e710)), _e863, (_e8023 < _e316)) == _e784) && (_e8021 > 0f)) && (_e8021 < _e7931)))) - select(0f, (_e7557 * _e7559), (((select(select(_e784, _e941, (_e8171 >= _e710)), _e863, (_e8171 < _e316)) == _e784) && (_e8169 > 0f)) && (_e8169 < _e8079)))), 1f, _e1001);
let _e8184 = (_e6931 & 31u);
let _e8186 = (1u << bitcast<u32>(_e8184));
let _e8195 = bitcast<i32>((((_e946 + _e8186) - 1u) >> bitcast<u32>(_e8184)));
let _e8196 = bitcast<i32>((((_e949 + _e8186) - 1u) >> bitcast<u32>(_e8184)));
if _e471 {
phi_66772_ = type_26(_e8196, _e8195);
} else {
phi_66772_ = type_26(_e8195, _e8196);
}
let _e8200 = phi_66772_;
let _e8205 = f32((1i << bitcast<u32>(_e8184)));
let _e8206 = (1f / _e8205);
let _e8208 = ((_e6952 * _e8206) - 0.5f);
let _e8210 = ((_e7045 * _e8206) - 0.5f);
let _e8212 = select(-1f, _e8208, (_e8208 > -1f));
let _e8214 = select(1e6f, _e8212, (_e8212 < 1e6f));
let _e8221 = select(0i, select(select(i32(_e8214), i32(-2147483648), (_e8214 < -2147483600f)), 2147483647i, (_e8214 > 2147483500f)), (_e8214 == _e8214));
let _e8225 = (_e8221 - select(0i, 1i, (_e8214 < f32(_e8221))));
let _e8227 = select(-1f, _e8210, (_e8210 > -1f));
let _e8229 = select(1e6f, _e8227, (_e8227 < 1e6f));
let _e8236 = select(0i, select(select(i32(_e8229), i32(-2147483648), (_e8229 < -2147483600f)), 2147483647i, (_e8229 > 2147483500f)), (_e8229 == _e8229));
let _e8240 = (_e8236 - select(0i, 1i, (_e8229 < f32(_e8236))));
let _e8242 = (_e8208 - f32(_e8225));
let _e8244 = (_e8210 - f32(_e8240));
let _e8245 = (1f - _e8242);
let _e8246 = (1f - _e8244);
let _e8249 = select(_e8225, 0i, (_e8225 < 0i));
let _e8250 = (_e8249 >= _e8200.member);
if _e8250 {
phi_66850_ = (_e8200.member - 1i);
} else {
phi_66850_ = _e8249;
}
let _e8253 = phi_66850_;
let _e8255 = select(_e8240, 0i, (_e8240 < 0i));
let _e8256 = (_e8255 >= _e8200.member_1);
if _e8256 {
phi_66861_ = (_e8200.member_1 - 1i);
} else {
phi_66861_ = _e8255;
}
let _e8259 = phi_66861_;
let _e8263 = (((f32(_e8253) + 0.5f) * _e8205) - 0.5f);
let _e8267 = (((f32(_e8259) + 0.5f) * _e8205) - 0.5f);
if _e471 {
phi_66889_ = type_26(_e8259, _e8253);
} else {
phi_66889_ = type_26(_e8253, _e8259);
}
let _e8273 = phi_66889_;
let _e8276 = (_e6931 == 0u);
if _e8276 {
phi_66940_ = 0u;
} else {
if (_e6931 == 1u) {
phi_66939_ = 0u;
} else {
if (_e6931 == 2u) {
phi_66938_ = _e7597;
} else {
phi_66938_ = select(_e7603, _e7600, (_e6931 == 3u));
}
let _e8282 = phi_66938_;
phi_66939_ = _e8282;
}
let _e8284 = phi_66939_;
phi_66940_ = _e8284;
}
let _e8286 = phi_66940_;
local_56 = (((bitcast<i32>(_e8286) + _e8273.member_1) * _e7594) + _e8273.member);
let _e8291 = local_56;
let _e8293 = select(_e7620, _e8291, (_e8291 < _e7620));
let _e8298 = global_6.member[bitcast<u32>(select(0i, _e8293, (_e8293 > 0i)))];
let _e8303 = (((((select(_e8263, _e8267, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e8308 = ((1f - (((select(_e8267, _e8263, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e8315 = ((_e7144.member * _e8303) + (_e7152.member * _e8308));
let _e8316 = ((_e7144.member_1 * _e8303) + (_e7152.member_1 * _e8308));
let _e8317 = ((_e7144.member_2 * _e8303) + (_e7152.member_2 * _e8308));
let _e8321 = select((_e7167.member + _e8315), _e7167.member, _e7165);
let _e8322 = select((_e7167.member_1 + _e8316), _e7167.member_1, _e7165);
let _e8323 = select((_e7167.member_2 + _e8317), _e7167.member_2, _e7165);
let _e8334 = (((_e8321 * _e8321) + (_e8322 * _e8322)) + (_e8323 * _e8323));
let _e8338 = (1f / sqrt(select(0f, _e8334, (_e8334 > 0f))));
let _e8339 = (_e8321 * _e8338);
let _e8340 = (_e8322 * _e8338);
let _e8341 = (_e8323 * _e8338);
let _e8342 = (_e593 - select(_e7178.member, (_e7178.member + _e8315), _e7165));
let _e8343 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e8316), _e7165));
let _e8344 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e8317), _e7165));
let _e8349 = (((_e8342 * _e8339) + (_e8343 * _e8340)) + (_e8344 * _e8341));
let _e8354 = (((_e8342 * _e631) + (_e8343 * _e644)) + (_e8344 * _e657));
let _e8359 = (((_e8339 * _e631) + (_e8340 * _e644)) + (_e8341 * _e657));
let _e8362 = ((_e8340 * _e657) - (_e8341 * _e644));
let _e8365 = ((_e8341 * _e631) - (_e8339 * _e657));
let _e8368 = ((_e8339 * _e644) - (_e8340 * _e631));
let _e8373 = (((_e8362 * _e8362) + (_e8365 * _e8365)) + (_e8368 * _e8368));
let _e8376 = (1f / select(1e-9f, _e8373, (_e8373 > 1e-9f)));
let _e8379 = ((_e8349 - (_e8359 * _e8354)) * _e8376);
let _e8382 = (((_e8359 * _e8349) - _e8354) * _e8376);
let _e8388 = select(0f, _e8379, (((_e8382 >= 0f) && (_e8382 < _e709)) && (_e8379 > 0f)));
let _e8390 = (_e8253 << bitcast<u32>(_e8184));
let _e8402 = (_e8225 + 1i);
let _e8405 = select(_e8402, 0i, (_e8402 < 0i));
let _e8406 = (_e8405 >= _e8200.member);
if _e8406 {
phi_67924_ = (_e8200.member - 1i);
} else {
phi_67924_ = _e8405;
}
let _e8409 = phi_67924_;
if _e8256 {
phi_67935_ = (_e8200.member_1 - 1i);
} else {
phi_67935_ = _e8255;
}
let _e8412 = phi_67935_;
let _e8416 = (((f32(_e8409) + 0.5f) * _e8205) - 0.5f);
let _e8420 = (((f32(_e8412) + 0.5f) * _e8205) - 0.5f);
if _e471 {
phi_67963_ = type_26(_e8412, _e8409);
} else {
phi_67963_ = type_26(_e8409, _e8412);
}
let _e8426 = phi_67963_;
if _e8276 {
phi_68014_ = 0u;
} else {
if (_e6931 == 1u) {
phi_68013_ = 0u;
} else {
if (_e6931 == 2u) {
phi_68012_ = _e7597;
} else {
phi_68012_ = select(_e7603, _e7600, (_e6931 == 3u));
}
let _e8434 = phi_68012_;
phi_68013_ = _e8434;
}
let _e8436 = phi_68013_;
phi_68014_ = _e8436;
}
let _e8438 = phi_68014_;
local_54 = (((bitcast<i32>(_e8438) + _e8426.member_1) * _e7594) + _e8426.member);
let _e8443 = local_54;
let _e8445 = select(_e7620, _e8443, (_e8443 < _e7620));
let _e8450 = global_6.member[bitcast<u32>(select(0i, _e8445, (_e8445 > 0i)))];
let _e8455 = (((((select(_e8416, _e8420, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e8460 = ((1f - (((select(_e8420, _e8416, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e8467 = ((_e7144.member * _e8455) + (_e7152.member * _e8460));
let _e8468 = ((_e7144.member_1 * _e8455) + (_e7152.member_1 * _e8460));
let _e8469 = ((_e7144.member_2 * _e8455) + (_e7152.member_2 * _e8460));
let _e8473 = select((_e7167.member + _e8467), _e7167.member, _e7165);
let _e8474 = select((_e7167.member_1 + _e8468), _e7167.member_1, _e7165);
let _e8475 = select((_e7167.member_2 + _e8469), _e7167.member_2, _e7165);
let _e8486 = (((_e8473 * _e8473) + (_e8474 * _e8474)) + (_e8475 * _e8475));
let _e8490 = (1f / sqrt(select(0f, _e8486, (_e8486 > 0f))));
let _e8491 = (_e8473 * _e8490);
let _e8492 = (_e8474 * _e8490);
let _e8493 = (_e8475 * _e8490);
let _e8494 = (_e593 - select(_e7178.member, (_e7178.member + _e8467), _e7165));
let _e8495 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e8468), _e7165));
let _e8496 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e8469), _e7165));
let _e8501 = (((_e8494 * _e8491) + (_e8495 * _e8492)) + (_e8496 * _e8493));
let _e8506 = (((_e8494 * _e631) + (_e8495 * _e644)) + (_e8496 * _e657));
let _e8511 = (((_e8491 * _e631) + (_e8492 * _e644)) + (_e8493 * _e657));
let _e8514 = ((_e8492 * _e657) - (_e8493 * _e644));
let _e8517 = ((_e8493 * _e631) - (_e8491 * _e657));
let _e8520 = ((_e8491 * _e644) - (_e8492 * _e631));
let _e8525 = (((_e8514 * _e8514) + (_e8517 * _e8517)) + (_e8520 * _e8520));
let _e8528 = (1f / select(1e-9f, _e8525, (_e8525 > 1e-9f)));
let _e8531 = ((_e8501 - (_e8511 * _e8506)) * _e8528);
let _e8534 = (((_e8511 * _e8501) - _e8506) * _e8528);
let _e8540 = select(0f, _e8531, (((_e8534 >= 0f) && (_e8534 < _e709)) && (_e8531 > 0f)));
let _e8542 = (_e8409 << bitcast<u32>(_e8184));
let _e8554 = (_e8240 + 1i);
if _e8250 {
phi_68998_ = (_e8200.member - 1i);
} else {
phi_68998_ = _e8249;
}
let _e8558 = phi_68998_;
let _e8560 = select(_e8554, 0i, (_e8554 < 0i));
let _e8561 = (_e8560 >= _e8200.member_1);
if _e8561 {
phi_69009_ = (_e8200.member_1 - 1i);
} else {
phi_69009_ = _e8560;
}
let _e8564 = phi_69009_;
let _e8568 = (((f32(_e8558) + 0.5f) * _e8205) - 0.5f);
let _e8572 = (((f32(_e8564) + 0.5f) * _e8205) - 0.5f);
if _e471 {
phi_69037_ = type_26(_e8564, _e8558);
} else {
phi_69037_ = type_26(_e8558, _e8564);
}
let _e8578 = phi_69037_;
if _e8276 {
phi_69088_ = 0u;
} else {
if (_e6931 == 1u) {
phi_69087_ = 0u;
} else {
if (_e6931 == 2u) {
phi_69086_ = _e7597;
} else {
phi_69086_ = select(_e7603, _e7600, (_e6931 == 3u));
}
let _e8586 = phi_69086_;
phi_69087_ = _e8586;
}
let _e8588 = phi_69087_;
phi_69088_ = _e8588;
}
let _e8590 = phi_69088_;
local_52 = (((bitcast<i32>(_e8590) + _e8578.member_1) * _e7594) + _e8578.member);
let _e8595 = local_52;
let _e8597 = select(_e7620, _e8595, (_e8595 < _e7620));
let _e8602 = global_6.member[bitcast<u32>(select(0i, _e8597, (_e8597 > 0i)))];
let _e8607 = (((((select(_e8568, _e8572, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e8612 = ((1f - (((select(_e8572, _e8568, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e8619 = ((_e7144.member * _e8607) + (_e7152.member * _e8612));
let _e8620 = ((_e7144.member_1 * _e8607) + (_e7152.member_1 * _e8612));
let _e8621 = ((_e7144.member_2 * _e8607) + (_e7152.member_2 * _e8612));
let _e8625 = select((_e7167.member + _e8619), _e7167.member, _e7165);
let _e8626 = select((_e7167.member_1 + _e8620), _e7167.member_1, _e7165);
let _e8627 = select((_e7167.member_2 + _e8621), _e7167.member_2, _e7165);
let _e8638 = (((_e8625 * _e8625) + (_e8626 * _e8626)) + (_e8627 * _e8627));
let _e8642 = (1f / sqrt(select(0f, _e8638, (_e8638 > 0f))));
let _e8643 = (_e8625 * _e8642);
let _e8644 = (_e8626 * _e8642);
let _e8645 = (_e8627 * _e8642);
let _e8646 = (_e593 - select(_e7178.member, (_e7178.member + _e8619), _e7165));
let _e8647 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e8620), _e7165));
let _e8648 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e8621), _e7165));
let _e8653 = (((_e8646 * _e8643) + (_e8647 * _e8644)) + (_e8648 * _e8645));
let _e8658 = (((_e8646 * _e631) + (_e8647 * _e644)) + (_e8648 * _e657));
let _e8663 = (((_e8643 * _e631) + (_e8644 * _e644)) + (_e8645 * _e657));
let _e8666 = ((_e8644 * _e657) - (_e8645 * _e644));
let _e8669 = ((_e8645 * _e631) - (_e8643 * _e657));
let _e8672 = ((_e8643 * _e644) - (_e8644 * _e631));
let _e8677 = (((_e8666 * _e8666) + (_e8669 * _e8669)) + (_e8672 * _e8672));
let _e8680 = (1f / select(1e-9f, _e8677, (_e8677 > 1e-9f)));
let _e8683 = ((_e8653 - (_e8663 * _e8658)) * _e8680);
let _e8686 = (((_e8663 * _e8653) - _e8658) * _e8680);
let _e8692 = select(0f, _e8683, (((_e8686 >= 0f) && (_e8686 < _e709)) && (_e8683 > 0f)));
let _e8694 = (_e8558 << bitcast<u32>(_e8184));
if _e8406 {
phi_70072_ = (_e8200.member - 1i);
} else {
phi_70072_ = _e8405;
}
let _e8709 = phi_70072_;
if _e8561 {
phi_70083_ = (_e8200.member_1 - 1i);
} else {
phi_70083_ = _e8560;
}
let _e8712 = phi_70083_;
let _e8716 = (((f32(_e8709) + 0.5f) * _e8205) - 0.5f);
let _e8720 = (((f32(_e8712) + 0.5f) * _e8205) - 0.5f);
if _e471 {
phi_70111_ = type_26(_e8712, _e8709);
} else {
phi_70111_ = type_26(_e8709, _e8712);
}
let _e8726 = phi_70111_;
if _e8276 {
phi_70162_ = 0u;
} else {
if (_e6931 == 1u) {
phi_70161_ = 0u;
} else {
if (_e6931 == 2u) {
phi_70160_ = _e7597;
} else {
phi_70160_ = select(_e7603, _e7600, (_e6931 == 3u));
}
let _e8734 = phi_70160_;
phi_70161_ = _e8734;
}
let _e8736 = phi_70161_;
phi_70162_ = _e8736;
}
let _e8738 = phi_70162_;
local_50 = (((bitcast<i32>(_e8738) + _e8726.member_1) * _e7594) + _e8726.member);
let _e8743 = local_50;
let _e8745 = select(_e7620, _e8743, (_e8743 < _e7620));
let _e8750 = global_6.member[bitcast<u32>(select(0i, _e8745, (_e8745 > 0i)))];
let _e8755 = (((((select(_e8716, _e8720, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e8760 = ((1f - (((select(_e8720, _e8716, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e8767 = ((_e7144.member * _e8755) + (_e7152.member * _e8760));
let _e8768 = ((_e7144.member_1 * _e8755) + (_e7152.member_1 * _e8760));
let _e8769 = ((_e7144.member_2 * _e8755) + (_e7152.member_2 * _e8760));
let _e8773 = select((_e7167.member + _e8767), _e7167.member, _e7165);
let _e8774 = select((_e7167.member_1 + _e8768), _e7167.member_1, _e7165);
let _e8775 = select((_e7167.member_2 + _e8769), _e7167.member_2, _e7165);
let _e8786 = (((_e8773 * _e8773) + (_e8774 * _e8774)) + (_e8775 * _e8775));
let _e8790 = (1f / sqrt(select(0f, _e8786, (_e8786 > 0f))));
let _e8791 = (_e8773 * _e8790);
let _e8792 = (_e8774 * _e8790);
let _e8793 = (_e8775 * _e8790);
let _e8794 = (_e593 - select(_e7178.member, (_e7178.member + _e8767), _e7165));
let _e8795 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e8768), _e7165));
let _e8796 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e8769), _e7165));
let _e8801 = (((_e8794 * _e8791) + (_e8795 * _e8792)) + (_e8796 * _e8793));
let _e8806 = (((_e8794 * _e631) + (_e8795 * _e644)) + (_e8796 * _e657));
let _e8811 = (((_e8791 * _e631) + (_e8792 * _e644)) + (_e8793 * _e657));
let _e8814 = ((_e8792 * _e657) - (_e8793 * _e644));
let _e8817 = ((_e8793 * _e631) - (_e8791 * _e657));
let _e8820 = ((_e8791 * _e644) - (_e8792 * _e631));
let _e8825 = (((_e8814 * _e8814) + (_e8817 * _e8817)) + (_e8820 * _e8820));
let _e8828 = (1f / select(1e-9f, _e8825, (_e8825 > 1e-9f)));
let _e8831 = ((_e8801 - (_e8811 * _e8806)) * _e8828);
let _e8834 = (((_e8811 * _e8801) - _e8806) * _e8828);
let _e8840 = select(0f, _e8831, (((_e8834 >= 0f) && (_e8834 < _e709)) && (_e8831 > 0f)));
let _e8842 = (_e8709 << bitcast<u32>(_e8184));
let _e8854 = select(((((_e8183 - select(0f, (_e8245 * _e8246), (((select(select(_e784, _e941, (_e8390 >= _e710)), _e863, (_e8390 < _e316)) == _e6931) && (_e8388 > 0f)) && (_e8388 < _e8298)))) - select(0f, (_e8242 * _e8246), (((select(select(_e784, _e941, (_e8542 >= _e710)), _e863, (_e8542 < _e316)) == _e6931) && (_e8540 > 0f)) && (_e8540 < _e8450)))) - select(0f, (_e8245 * _e8244), (((select(select(_e784, _e941, (_e8694 >= _e710)), _e863, (_e8694 < _e316)) == _e6931) && (_e8692 > 0f)) && (_e8692 < _e8602)))) - select(0f, (_e8242 * _e8244), (((select(select(_e784, _e941, (_e8842 >= _e710)), _e863, (_e8842 < _e316)) == _e6931) && (_e8840 > 0f)) && (_e8840 < _e8750)))), _e8183, _e8276);
let _e8855 = (_e6935 & 31u);
let _e8857 = (1u << bitcast<u32>(_e8855));
let _e8866 = bitcast<i32>((((_e946 + _e8857) - 1u) >> bitcast<u32>(_e8855)));
let _e8867 = bitcast<i32>((((_e949 + _e8857) - 1u) >> bitcast<u32>(_e8855)));
if _e471 {
phi_71164_ = type_26(_e8867, _e8866);
} else {
phi_71164_ = type_26(_e8866, _e8867);
}
let _e8871 = phi_71164_;
let _e8876 = f32((1i << bitcast<u32>(_e8855)));
let _e8877 = (1f / _e8876);
let _e8879 = ((_e6952 * _e8877) - 0.5f);
let _e8881 = ((_e7045 * _e8877) - 0.5f);
let _e8883 = select(-1f, _e8879, (_e8879 > -1f));
let _e8885 = select(1e6f, _e8883, (_e8883 < 1e6f));
let _e8892 = select(0i, select(select(i32(_e8885), i32(-2147483648), (_e8885 < -2147483600f)), 2147483647i, (_e8885 > 2147483500f)), (_e8885 == _e8885));
let _e8896 = (_e8892 - select(0i, 1i, (_e8885 < f32(_e8892))));
let _e8898 = select(-1f, _e8881, (_e8881 > -1f));
let _e8900 = select(1e6f, _e8898, (_e8898 < 1e6f));
let _e8907 = select(0i, select(select(i32(_e8900), i32(-2147483648), (_e8900 < -2147483600f)), 2147483647i, (_e8900 > 2147483500f)), (_e8900 == _e8900));
let _e8911 = (_e8907 - select(0i, 1i, (_e8900 < f32(_e8907))));
let _e8913 = (_e8879 - f32(_e8896));
let _e8915 = (_e8881 - f32(_e8911));
let _e8916 = (1f - _e8913);
let _e8917 = (1f - _e8915);
let _e8920 = select(_e8896, 0i, (_e8896 < 0i));
let _e8921 = (_e8920 >= _e8871.member);
if _e8921 {
phi_71242_ = (_e8871.member - 1i);
} else {
phi_71242_ = _e8920;
}
let _e8924 = phi_71242_;
let _e8926 = select(_e8911, 0i, (_e8911 < 0i));
let _e8927 = (_e8926 >= _e8871.member_1);
if _e8927 {
phi_71253_ = (_e8871.member_1 - 1i);
} else {
phi_71253_ = _e8926;
}
let _e8930 = phi_71253_;
let _e8934 = (((f32(_e8924) + 0.5f) * _e8876) - 0.5f);
let _e8938 = (((f32(_e8930) + 0.5f) * _e8876) - 0.5f);
if _e471 {
phi_71281_ = type_26(_e8930, _e8924);
} else {
phi_71281_ = type_26(_e8924, _e8930);
}
let _e8944 = phi_71281_;
let _e8947 = (_e6935 == 0u);
if _e8947 {
phi_71332_ = 0u;
} else {
if (_e6935 == 1u) {
phi_71331_ = 0u;
} else {
if (_e6935 == 2u) {
phi_71330_ = _e7597;
} else {
phi_71330_ = select(_e7603, _e7600, (_e6935 == 3u));
}
let _e8953 = phi_71330_;
phi_71331_ = _e8953;
}
let _e8955 = phi_71331_;
phi_71332_ = _e8955;
}
let _e8957 = phi_71332_;
local_48 = (((bitcast<i32>(_e8957) + _e8944.member_1) * _e7594) + _e8944.member);
let _e8962 = local_48;
let _e8964 = select(_e7620, _e8962, (_e8962 < _e7620));
let _e8969 = global_6.member[bitcast<u32>(select(0i, _e8964, (_e8964 > 0i)))];
let _e8974 = (((((select(_e8934, _e8938, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e8979 = ((1f - (((select(_e8938, _e8934, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e8986 = ((_e7144.member * _e8974) + (_e7152.member * _e8979));
let _e8987 = ((_e7144.member_1 * _e8974) + (_e7152.member_1 * _e8979));
let _e8988 = ((_e7144.member_2 * _e8974) + (_e7152.member_2 * _e8979));
let _e8992 = select((_e7167.member + _e8986), _e7167.member, _e7165);
let _e8993 = select((_e7167.member_1 + _e8987), _e7167.member_1, _e7165);
let _e8994 = select((_e7167.member_2 + _e8988), _e7167.member_2, _e7165);
let _e9005 = (((_e8992 * _e8992) + (_e8993 * _e8993)) + (_e8994 * _e8994));
let _e9009 = (1f / sqrt(select(0f, _e9005, (_e9005 > 0f))));
let _e9010 = (_e8992 * _e9009);
let _e9011 = (_e8993 * _e9009);
let _e9012 = (_e8994 * _e9009);
let _e9013 = (_e593 - select(_e7178.member, (_e7178.member + _e8986), _e7165));
let _e9014 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e8987), _e7165));
let _e9015 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e8988), _e7165));
let _e9020 = (((_e9013 * _e9010) + (_e9014 * _e9011)) + (_e9015 * _e9012));
let _e9025 = (((_e9013 * _e631) + (_e9014 * _e644)) + (_e9015 * _e657));
let _e9030 = (((_e9010 * _e631) + (_e9011 * _e644)) + (_e9012 * _e657));
let _e9033 = ((_e9011 * _e657) - (_e9012 * _e644));
let _e9036 = ((_e9012 * _e631) - (_e9010 * _e657));
let _e9039 = ((_e9010 * _e644) - (_e9011 * _e631));
let _e9044 = (((_e9033 * _e9033) + (_e9036 * _e9036)) + (_e9039 * _e9039));
let _e9047 = (1f / select(1e-9f, _e9044, (_e9044 > 1e-9f)));
let _e9050 = ((_e9020 - (_e9030 * _e9025)) * _e9047);
let _e9053 = (((_e9030 * _e9020) - _e9025) * _e9047);
let _e9059 = select(0f, _e9050, (((_e9053 >= 0f) && (_e9053 < _e709)) && (_e9050 > 0f)));
let _e9061 = (_e8924 << bitcast<u32>(_e8855));
let _e9073 = (_e8896 + 1i);
let _e9076 = select(_e9073, 0i, (_e9073 < 0i));
let _e9077 = (_e9076 >= _e8871.member);
if _e9077 {
phi_72316_ = (_e8871.member - 1i);
} else {
phi_72316_ = _e9076;
}
let _e9080 = phi_72316_;
if _e8927 {
phi_72327_ = (_e8871.member_1 - 1i);
} else {
phi_72327_ = _e8926;
}
let _e9083 = phi_72327_;
let _e9087 = (((f32(_e9080) + 0.5f) * _e8876) - 0.5f);
let _e9091 = (((f32(_e9083) + 0.5f) * _e8876) - 0.5f);
if _e471 {
phi_72355_ = type_26(_e9083, _e9080);
} else {
phi_72355_ = type_26(_e9080, _e9083);
}
let _e9097 = phi_72355_;
if _e8947 {
phi_72406_ = 0u;
} else {
if (_e6935 == 1u) {
phi_72405_ = 0u;
} else {
if (_e6935 == 2u) {
phi_72404_ = _e7597;
} else {
phi_72404_ = select(_e7603, _e7600, (_e6935 == 3u));
}
let _e9105 = phi_72404_;
phi_72405_ = _e9105;
}
let _e9107 = phi_72405_;
phi_72406_ = _e9107;
}
let _e9109 = phi_72406_;
local_46 = (((bitcast<i32>(_e9109) + _e9097.member_1) * _e7594) + _e9097.member);
let _e9114 = local_46;
let _e9116 = select(_e7620, _e9114, (_e9114 < _e7620));
let _e9121 = global_6.member[bitcast<u32>(select(0i, _e9116, (_e9116 > 0i)))];
let _e9126 = (((((select(_e9087, _e9091, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e9131 = ((1f - (((select(_e9091, _e9087, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e9138 = ((_e7144.member * _e9126) + (_e7152.member * _e9131));
let _e9139 = ((_e7144.member_1 * _e9126) + (_e7152.member_1 * _e9131));
let _e9140 = ((_e7144.member_2 * _e9126) + (_e7152.member_2 * _e9131));
let _e9144 = select((_e7167.member + _e9138), _e7167.member, _e7165);
let _e9145 = select((_e7167.member_1 + _e9139), _e7167.member_1, _e7165);
let _e9146 = select((_e7167.member_2 + _e9140), _e7167.member_2, _e7165);
let _e9157 = (((_e9144 * _e9144) + (_e9145 * _e9145)) + (_e9146 * _e9146));
let _e9161 = (1f / sqrt(select(0f, _e9157, (_e9157 > 0f))));
let _e9162 = (_e9144 * _e9161);
let _e9163 = (_e9145 * _e9161);
let _e9164 = (_e9146 * _e9161);
let _e9165 = (_e593 - select(_e7178.member, (_e7178.member + _e9138), _e7165));
let _e9166 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e9139), _e7165));
let _e9167 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e9140), _e7165));
let _e9172 = (((_e9165 * _e9162) + (_e9166 * _e9163)) + (_e9167 * _e9164));
let _e9177 = (((_e9165 * _e631) + (_e9166 * _e644)) + (_e9167 * _e657));
let _e9182 = (((_e9162 * _e631) + (_e9163 * _e644)) + (_e9164 * _e657));
let _e9185 = ((_e9163 * _e657) - (_e9164 * _e644));
let _e9188 = ((_e9164 * _e631) - (_e9162 * _e657));
let _e9191 = ((_e9162 * _e644) - (_e9163 * _e631));
let _e9196 = (((_e9185 * _e9185) + (_e9188 * _e9188)) + (_e9191 * _e9191));
let _e9199 = (1f / select(1e-9f, _e9196, (_e9196 > 1e-9f)));
let _e9202 = ((_e9172 - (_e9182 * _e9177)) * _e9199);
let _e9205 = (((_e9182 * _e9172) - _e9177) * _e9199);
let _e9211 = select(0f, _e9202, (((_e9205 >= 0f) && (_e9205 < _e709)) && (_e9202 > 0f)));
let _e9213 = (_e9080 << bitcast<u32>(_e8855));
let _e9225 = (_e8911 + 1i);
if _e8921 {
phi_73390_ = (_e8871.member - 1i);
} else {
phi_73390_ = _e8920;
}
let _e9229 = phi_73390_;
let _e9231 = select(_e9225, 0i, (_e9225 < 0i));
let _e9232 = (_e9231 >= _e8871.member_1);
if _e9232 {
phi_73401_ = (_e8871.member_1 - 1i);
} else {
phi_73401_ = _e9231;
}
let _e9235 = phi_73401_;
let _e9239 = (((f32(_e9229) + 0.5f) * _e8876) - 0.5f);
let _e9243 = (((f32(_e9235) + 0.5f) * _e8876) - 0.5f);
if _e471 {
phi_73429_ = type_26(_e9235, _e9229);
} else {
phi_73429_ = type_26(_e9229, _e9235);
}
let _e9249 = phi_73429_;
if _e8947 {
phi_73480_ = 0u;
} else {
if (_e6935 == 1u) {
phi_73479_ = 0u;
} else {
if (_e6935 == 2u) {
phi_73478_ = _e7597;
} else {
phi_73478_ = select(_e7603, _e7600, (_e6935 == 3u));
}
let _e9257 = phi_73478_;
phi_73479_ = _e9257;
}
let _e9259 = phi_73479_;
phi_73480_ = _e9259;
}
let _e9261 = phi_73480_;
local_44 = (((bitcast<i32>(_e9261) + _e9249.member_1) * _e7594) + _e9249.member);
let _e9266 = local_44;
let _e9268 = select(_e7620, _e9266, (_e9266 < _e7620));
let _e9273 = global_6.member[bitcast<u32>(select(0i, _e9268, (_e9268 > 0i)))];
let _e9278 = (((((select(_e9239, _e9243, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e9283 = ((1f - (((select(_e9243, _e9239, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e9290 = ((_e7144.member * _e9278) + (_e7152.member * _e9283));
let _e9291 = ((_e7144.member_1 * _e9278) + (_e7152.member_1 * _e9283));
let _e9292 = ((_e7144.member_2 * _e9278) + (_e7152.member_2 * _e9283));
let _e9296 = select((_e7167.member + _e9290), _e7167.member, _e7165);
let _e9297 = select((_e7167.member_1 + _e9291), _e7167.member_1, _e7165);
let _e9298 = select((_e7167.member_2 + _e9292), _e7167.member_2, _e7165);
let _e9309 = (((_e9296 * _e9296) + (_e9297 * _e9297)) + (_e9298 * _e9298));
let _e9313 = (1f / sqrt(select(0f, _e9309, (_e9309 > 0f))));
let _e9314 = (_e9296 * _e9313);
let _e9315 = (_e9297 * _e9313);
let _e9316 = (_e9298 * _e9313);
let _e9317 = (_e593 - select(_e7178.member, (_e7178.member + _e9290), _e7165));
let _e9318 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e9291), _e7165));
let _e9319 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e9292), _e7165));
let _e9324 = (((_e9317 * _e9314) + (_e9318 * _e9315)) + (_e9319 * _e9316));
let _e9329 = (((_e9317 * _e631) + (_e9318 * _e644)) + (_e9319 * _e657));
let _e9334 = (((_e9314 * _e631) + (_e9315 * _e644)) + (_e9316 * _e657));
let _e9337 = ((_e9315 * _e657) - (_e9316 * _e644));
let _e9340 = ((_e9316 * _e631) - (_e9314 * _e657));
let _e9343 = ((_e9314 * _e644) - (_e9315 * _e631));
let _e9348 = (((_e9337 * _e9337) + (_e9340 * _e9340)) + (_e9343 * _e9343));
let _e9351 = (1f / select(1e-9f, _e9348, (_e9348 > 1e-9f)));
let _e9354 = ((_e9324 - (_e9334 * _e9329)) * _e9351);
let _e9357 = (((_e9334 * _e9324) - _e9329) * _e9351);
let _e9363 = select(0f, _e9354, (((_e9357 >= 0f) && (_e9357 < _e709)) && (_e9354 > 0f)));
let _e9365 = (_e9229 << bitcast<u32>(_e8855));
if _e9077 {
phi_74464_ = (_e8871.member - 1i);
} else {
phi_74464_ = _e9076;
}
let _e9380 = phi_74464_;
if _e9232 {
phi_74475_ = (_e8871.member_1 - 1i);
} else {
phi_74475_ = _e9231;
}
let _e9383 = phi_74475_;
let _e9387 = (((f32(_e9380) + 0.5f) * _e8876) - 0.5f);
let _e9391 = (((f32(_e9383) + 0.5f) * _e8876) - 0.5f);
if _e471 {
phi_74503_ = type_26(_e9383, _e9380);
} else {
phi_74503_ = type_26(_e9380, _e9383);
}
let _e9397 = phi_74503_;
if _e8947 {
phi_74554_ = 0u;
} else {
if (_e6935 == 1u) {
phi_74553_ = 0u;
} else {
if (_e6935 == 2u) {
phi_74552_ = _e7597;
} else {
phi_74552_ = select(_e7603, _e7600, (_e6935 == 3u));
}
let _e9405 = phi_74552_;
phi_74553_ = _e9405;
}
let _e9407 = phi_74553_;
phi_74554_ = _e9407;
}
let _e9409 = phi_74554_;
local_42 = (((bitcast<i32>(_e9409) + _e9397.member_1) * _e7594) + _e9397.member);
let _e9414 = local_42;
let _e9416 = select(_e7620, _e9414, (_e9414 < _e7620));
let _e9421 = global_6.member[bitcast<u32>(select(0i, _e9416, (_e9416 > 0i)))];
let _e9426 = (((((select(_e9387, _e9391, _e471) + 0.5f) / _e7125) * 2f) - 1f) * _e7133);
let _e9431 = ((1f - (((select(_e9391, _e9387, _e471) + 0.5f) / _e7126) * 2f)) * _e7141);
let _e9438 = ((_e7144.member * _e9426) + (_e7152.member * _e9431));
let _e9439 = ((_e7144.member_1 * _e9426) + (_e7152.member_1 * _e9431));
let _e9440 = ((_e7144.member_2 * _e9426) + (_e7152.member_2 * _e9431));
let _e9444 = select((_e7167.member + _e9438), _e7167.member, _e7165);
let _e9445 = select((_e7167.member_1 + _e9439), _e7167.member_1, _e7165);
let _e9446 = select((_e7167.member_2 + _e9440), _e7167.member_2, _e7165);
let _e9457 = (((_e9444 * _e9444) + (_e9445 * _e9445)) + (_e9446 * _e9446));
let _e9461 = (1f / sqrt(select(0f, _e9457, (_e9457 > 0f))));
let _e9462 = (_e9444 * _e9461);
let _e9463 = (_e9445 * _e9461);
let _e9464 = (_e9446 * _e9461);
let _e9465 = (_e593 - select(_e7178.member, (_e7178.member + _e9438), _e7165));
let _e9466 = (_e605 - select(_e7178.member_1, (_e7178.member_1 + _e9439), _e7165));
let _e9467 = (_e618 - select(_e7178.member_2, (_e7178.member_2 + _e9440), _e7165));
let _e9472 = (((_e9465 * _e9462) + (_e9466 * _e9463)) + (_e9467 * _e9464));
let _e9477 = (((_e9465 * _e631) + (_e9466 * _e644)) + (_e9467 * _e657));
let _e9482 = (((_e9462 * _e631) + (_e9463 * _e644)) + (_e9464 * _e657));
let _e9485 = ((_e9463 * _e657) - (_e9464 * _e644));
let _e9488 = ((_e9464 * _e631) - (_e9462 * _e657));
let _e9491 = ((_e9462 * _e644) - (_e9463 * _e631));
let _e9496 = (((_e9485 * _e9485) + (_e9488 * _e9488)) + (_e9491 * _e9491));
let _e9499 = (1f / select(1e-9f, _e9496, (_e9496 > 1e-9f)));
let _e9502 = ((_e9472 - (_e9482 * _e9477)) * _e9499);
let _e9505 = (((_e9482 * _e9472) - _e9477) * _e9499);
let _e9511 = select(0f, _e9502, (((_e9505 >= 0f) && (_e9505 < _e709)) && (_e9502 > 0f)));
let _e9513 = (_e9380 << bitcast<u32>(_e8855));
let _e9525 = select(((((_e8854 - select(0f, (_e8916 * _e8917), (((select(select(_e784, _e941, (_e9061 >= _e710)), _e863, (_e9061 < _e316)) == _e6935) && (_e9059 > 0f)) && (_e9059 < _e8969)))) - select(0f, (_e8913 * _e8917), (((select(select(_e784, _e941, (_e9213 >= _e710)), _e863, (_e9213 < _e316)) == _e6935) && (_e9211 > 0f)) && (_e9211 < _e9121)))) - select(0f, (_e8916 * _e8915), (((select(select(_e784, _e941, (_e9365 >= _e710)), _e863, (_e9365 < _e316)) == _e6935) && (_e9363 > 0f)) && (_e9363 < _e9273)))) - select(0f, (_e8913 * _e8915), (((select(select(_e784, _e941, (_e9513 >= _e710)), _e863, (_e9513 < _e316)) == _e6935) && (_e9511 > 0f)) && (_e9511 < _e9421)))), _e8854, _e8947);
if _e471 {
phi_75547_ = type_26(_e7042, _e6950);
} else {
phi_75547_ = type_26(_e6950, _e7042);
}
let _e9540 = phi_75547_;
let _e9543 = (_e7043 && (((_e7498 > 0f) && (_e7498 < _e7122)) && (bitcast<f32>((bitcast<u32>(_e9525) & 2147483647u)) > 1e-6f)));
let _e9546 = global_1.member.member_18.member;
let _e9547 = (((select(_e7068, (1f - _e7068), (_e7053 >= 0f)) - select(_e7087, (1f - _e7087), (_e7072 >= 0f))) * (1f / _e7050)) * _e9546);
let _e9551 = select(0f, (((((_e670 * _e7485.member) * ((1f + (_e7366 * (1f + (_e7366 * (0.5f + (_e7366 * (0.16666667f + (_e7366 * (0.041666668f + (_e7366 * (0.008333334f + (_e7366 * (0.001388889f + (_e7366 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7361 + 127i)) << bitcast<u32>(23i))))) * _e7328) * _e9525) * _e9547), _e9543);
let _e9552 = select(0f, (((((_e683 * _e7485.member_1) * ((1f + (_e7414 * (1f + (_e7414 * (0.5f + (_e7414 * (0.16666667f + (_e7414 * (0.041666668f + (_e7414 * (0.008333334f + (_e7414 * (0.001388889f + (_e7414 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7409 + 127i)) << bitcast<u32>(23i))))) * _e7328) * _e9525) * _e9547), _e9543);
let _e9553 = select(0f, (((((_e696 * _e7485.member_2) * ((1f + (_e7462 * (1f + (_e7462 * (0.5f + (_e7462 * (0.16666667f + (_e7462 * (0.041666668f + (_e7462 * (0.008333334f + (_e7462 * (0.001388889f + (_e7462 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7457 + 127i)) << bitcast<u32>(23i))))) * _e7328) * _e9525) * _e9547), _e9543);
let _e9557 = (bitcast<f32>((bitcast<u32>(_e9551) & 2147483647u)) >= 1073741800f);
let _e9558 = (1f / 1048576f);
let _e9561 = ((_e9551 * select(1f, _e9558, _e9557)) + 0.5f);
let _e9563 = select(-1073741800f, _e9561, (_e9561 > -1073741800f));
let _e9565 = select(1073741800f, _e9563, (_e9563 < 1073741800f));
let _e9572 = select(0i, select(select(i32(_e9565), i32(-2147483648), (_e9565 < -2147483600f)), 2147483647i, (_e9565 > 2147483500f)), (_e9565 == _e9565));
let _e9576 = (_e9572 - select(0i, 1i, (_e9565 < f32(_e9572))));
let _e9577 = select(0i, 20i, _e9557);
let _e9581 = (bitcast<u32>(_e9576) << bitcast<u32>((_e9577 & 31i)));
let _e9588 = bitcast<u32>(((_e9576 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9577) & 31i))));
let _e9592 = (bitcast<f32>((bitcast<u32>(_e9552) & 2147483647u)) >= 1073741800f);
let _e9595 = ((_e9552 * select(1f, _e9558, _e9592)) + 0.5f);
let _e9597 = select(-1073741800f, _e9595, (_e9595 > -1073741800f));
let _e9599 = select(1073741800f, _e9597, (_e9597 < 1073741800f));
let _e9606 = select(0i, select(select(i32(_e9599), i32(-2147483648), (_e9599 < -2147483600f)), 2147483647i, (_e9599 > 2147483500f)), (_e9599 == _e9599));
let _e9610 = (_e9606 - select(0i, 1i, (_e9599 < f32(_e9606))));
let _e9611 = select(0i, 20i, _e9592);
let _e9615 = (bitcast<u32>(_e9610) << bitcast<u32>((_e9611 & 31i)));
let _e9622 = bitcast<u32>(((_e9610 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9611) & 31i))));
let _e9626 = (bitcast<f32>((bitcast<u32>(_e9553) & 2147483647u)) >= 1073741800f);
let _e9629 = ((_e9553 * select(1f, _e9558, _e9626)) + 0.5f);
let _e9631 = select(-1073741800f, _e9629, (_e9629 > -1073741800f));
let _e9633 = select(1073741800f, _e9631, (_e9631 < 1073741800f));
let _e9640 = select(0i, select(select(i32(_e9633), i32(-2147483648), (_e9633 < -2147483600f)), 2147483647i, (_e9633 > 2147483500f)), (_e9633 == _e9633));
let _e9644 = (_e9640 - select(0i, 1i, (_e9633 < f32(_e9640))));
let _e9645 = select(0i, 20i, _e9626);
let _e9649 = (bitcast<u32>(_e9644) << bitcast<u32>((_e9645 & 31i)));
let _e9656 = bitcast<u32>(((_e9644 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9645) & 31i))));
let _e9661 = bitcast<i32>(bitcast<u32>((((_e9540.member_1 * _e950) + _e9540.member) * 6i)));
if ((_e9581 | _e9588) == 0u) {
} else {
let _e9664 = bitcast<u32>(_e9661);
if (_e9664 < _e288) {
let _e9668 = atomicAdd((&global_8.member[_e9664]), _e9581);
phi_75780_ = _e9668;
} else {
phi_75780_ = 0u;
}
let _e9670 = phi_75780_;
let _e9674 = (_e9588 + select(0u, 1u, ((_e9670 + _e9581) < _e9581)));
if (_e9674 == 0u) {
} else {
let _e9676 = (_e9664 + 1u);
if (_e9676 < _e288) {
let _e9680 = atomicAdd((&global_8.member[_e9676]), _e9674);
}
}
}
if ((_e9615 | _e9622) == 0u) {
} else {
let _e9684 = bitcast<u32>((_e9661 + 2i));
if (_e9684 < _e288) {
let _e9688 = atomicAdd((&global_8.member[_e9684]), _e9615);
phi_75810_ = _e9688;
} else {
phi_75810_ = 0u;
}
let _e9690 = phi_75810_;
let _e9694 = (_e9622 + select(0u, 1u, ((_e9690 + _e9615) < _e9615)));
if (_e9694 == 0u) {
} else {
let _e9696 = (_e9684 + 1u);
if (_e9696 < _e288) {
let _e9700 = atomicAdd((&global_8.member[_e9696]), _e9694);
}
}
}
if ((_e9649 | _e9656) == 0u) {
} else {
let _e9704 = bitcast<u32>((_e9661 + 4i));
if (_e9704 < _e288) {
let _e9708 = atomicAdd((&global_8.member[_e9704]), _e9649);
phi_75840_ = _e9708;
} else {
phi_75840_ = 0u;
}
let _e9710 = phi_75840_;
let _e9714 = (_e9656 + select(0u, 1u, ((_e9710 + _e9649) < _e9649)));
if (_e9714 == 0u) {
} else {
let _e9716 = (_e9704 + 1u);
if (_e9716 < _e288) {
let _e9720 = atomicAdd((&global_8.member[_e9716]), _e9714);
}
}
}
phi_61223_ = (_e7040 + 1i);
} else {
phi_61223_ = i32();
}
let _e9723 = phi_61223_;
continue;
continuing {
phi_61222_ = _e9723;
break if !(_e7043);
}
}
phi_61069_ = (_e6947 + 1i);
} else {
phi_61069_ = i32();
}
let _e9727 = phi_61069_;
continue;
continuing {
phi_61068_ = _e9727;
break if !(_e6948);
}
}
}
}
} else {
let _e1002 = (_e784 & 31u);
let _e1004 = (1u << bitcast<u32>(_e1002));
let _e1013 = bitcast<i32>((((_e946 + _e1004) - 1u) >> bitcast<u32>(_e1002)));
let _e1014 = bitcast<i32>((((_e949 + _e1004) - 1u) >> bitcast<u32>(_e1002)));
if _e471 {
phi_75906_ = type_26(_e1014, _e1013);
} else {
phi_75906_ = type_26(_e1013, _e1014);
}
let _e1018 = phi_75906_;
let _e1022 = (_e976 >> bitcast<u32>(_e1002));
if (_e1022 < _e1018.member) {
phi_75981_ = _e1022;
} else {
phi_75981_ = (_e1018.member - 1i);
}
let _e1028 = phi_75981_;
phi_75985_ = type_26(2147483647i, -1i);
phi_75988_ = 0i;
loop {
let _e1031 = phi_75985_;
let _e1033 = phi_75988_;
local_241 = _e1031;
local_242 = _e1031;
let _e1034 = (_e1033 < 16i);
if _e1034 {
let _e1036 = (1i << bitcast<u32>(_e1002));
let _e1037 = f32(_e1036);
let _e1039 = ((4u - _e784) & 31u);
let _e1044 = ((_e994 >> bitcast<u32>(_e1002)) + (_e1033 & ((1i << bitcast<u32>(_e1039)) - 1i)));
let _e1048 = (((f32(_e1044) + 0.5f) * _e1037) - 0.5f);
let _e1052 = (-(((_e434 * _e1048) + _e460)) / _e447);
let _e1059 = bitcast<f32>((bitcast<u32>(((_e484 * _e1048) + ((_e497 * _e1052) + _e510))) & 2147483647u));
let _e1066 = bitcast<f32>((bitcast<u32>(((_e523 * _e1048) + ((_e536 * _e1052) + _e549))) & 2147483647u));
let _e1071 = (((0.5f * (_e1059 + _e1066)) / _e552) + (0.5f * _e1037));
let _e1072 = (1f / _e1037);
let _e1080 = ((((_e1052 + _e1071) + 0.5f) * _e1072) - 0.5f);
let _e1081 = f32((_e1018.member_1 - 1i));
let _e1082 = (0f - 1f);
let _e1084 = select(_e1082, _e1080, (_e1080 > _e1082));
let _e1086 = select(_e1081, _e1084, (_e1084 < _e1081));
let _e1093 = select(0i, select(select(i32(_e1086), i32(-2147483648), (_e1086 < -2147483600f)), 2147483647i, (_e1086 > 2147483500f)), (_e1086 == _e1086));
let _e1098 = (((((_e1052 - _e1071) + 0.5f) * _e1072) - 0.5f) + 1f);
let _e1099 = (_e1081 + 1f);
let _e1101 = select(0f, _e1098, (_e1098 > 0f));
let _e1103 = select(_e1099, _e1101, (_e1101 < _e1099));
let _e1110 = select(0i, select(select(i32(_e1103), i32(-2147483648), (_e1103 < -2147483600f)), 2147483647i, (_e1103 > 2147483500f)), (_e1103 == _e1103));
let _e1121 = ((1e-4f * _e1037) * _e552);
let _e1123 = select(_e1066, _e1059, (_e1059 > _e1066));
let _e1125 = select(_e1121, _e1123, (_e1123 > _e1121));
let _e1127 = select(_e1066, _e1059, (_e1059 < _e1066));
let _e1129 = select(_e1121, _e1127, (_e1127 > _e1121));
let _e1131 = (0.5f * (_e1125 + _e1129));
let _e1132 = (0.5f / _e1129);
let _e1133 = (1f / _e1125);
phi_76139_ = _e1031;
phi_76142_ = 0i;
loop {
let _e1135 = phi_76139_;
let _e1137 = phi_76142_;
local_254 = _e1135;
let _e1140 = (((_e1110 - select(0i, 1i, (_e1103 < f32(_e1110)))) + (_e1033 >> bitcast<u32>(_e1039))) + (_e1137 << bitcast<u32>(_e1002)));
let _e1141 = (_e1140 <= select(-1i, (_e1093 - select(0i, 1i, (_e1086 < f32(_e1093)))), (_e1044 <= _e1028)));
if _e1141 {
let _e1145 = (((f32(_e1140) + 0.5f) * _e1037) - 0.5f);
let _e1147 = ((_e1145 - _e1052) * _e552);
let _e1148 = (_e552 * _e1037);
let _e1150 = (0.5f * _e1148);
let _e1151 = (_e1147 + _e1150);
let _e1152 = -(_e1151);
let _e1155 = (_e1131 - select(_e1152, _e1151, (_e1151 > _e1152)));
let _e1157 = select(0f, _e1155, (_e1155 > 0f));
let _e1159 = select(_e1129, _e1157, (_e1157 < _e1129));
let _e1162 = (_e1155 - _e1129);
let _e1166 = (((_e1159 * (_e1159 * _e1132)) + select(0f, _e1162, (_e1162 > 0f))) * _e1133);
let _e1170 = (_e1147 - _e1150);
let _e1171 = -(_e1170);
let _e1174 = (_e1131 - select(_e1171, _e1170, (_e1170 > _e1171)));
let _e1176 = select(0f, _e1174, (_e1174 > 0f));
let _e1178 = select(_e1129, _e1176, (_e1176 < _e1129));
let _e1181 = (_e1174 - _e1129);
let _e1185 = (((_e1178 * (_e1178 * _e1132)) + select(0f, _e1181, (_e1181 > 0f))) * _e1133);
if _e471 {
phi_76272_ = type_26(_e1140, _e1044);
} else {
phi_76272_ = type_26(_e1044, _e1140);
}
let _e1196 = phi_76272_;
let _e1202 = bitcast<i32>(((_e946 + 1u) >> bitcast<u32>(1u)));
let _e1205 = global_1.member.member_18.member_9;
let _e1210 = global_1.member.member_18.member_6;
let _e1213 = global_1.member.member_18.member_7;
let _e1216 = global_1.member.member_18.member_8;
if _e1001 {
phi_76323_ = 0u;
} else {
if (_e784 == 1u) {
phi_76322_ = 0u;
} else {
if (_e784 == 2u) {
phi_76321_ = _e1210;
} else {
phi_76321_ = select(_e1216, _e1213, (_e784 == 3u));
}
let _e1222 = phi_76321_;
phi_76322_ = _e1222;
}
let _e1224 = phi_76322_;
phi_76323_ = _e1224;
}
let _e1226 = phi_76323_;
local_40 = (((bitcast<i32>(_e1226) + _e1196.member_1) * _e1202) + _e1196.member);
local_41 = (_e1202 * bitcast<i32>(_e1205));
let _e1231 = local_40;
let _e1233 = (bitcast<i32>(_e280) - 1i);
let _e1235 = select(_e1233, _e1231, (_e1231 < _e1233));
let _e1240 = global_6.member[bitcast<u32>(select(0i, _e1235, (_e1235 > 0i)))];
let _e1241 = local_41;
let _e1242 = local_40;
let _e1243 = (_e1241 + _e1242);
let _e1245 = select(_e1233, _e1243, (_e1243 < _e1233));
let _e1250 = global_6.member[bitcast<u32>(select(0i, _e1245, (_e1245 > 0i)))];
let _e1251 = local_41;
let _e1253 = local_40;
let _e1254 = ((2i * _e1251) + _e1253);
let _e1256 = select(_e1233, _e1254, (_e1254 < _e1233));
let _e1261 = global_6.member[bitcast<u32>(select(0i, _e1256, (_e1256 > 0i)))];
let _e1263 = (_e1036 >> bitcast<u32>(1i));
let _e1266 = ((_e1196.member << bitcast<u32>(_e1002)) + _e1263);
let _e1269 = ((_e1196.member_1 << bitcast<u32>(_e1002)) + _e1263);
let _e1271 = select(_e1266, 0i, (_e1266 < 0i));
if (_e1271 >= _e950) {
phi_76449_ = (_e950 - 1i);
} else {
phi_76449_ = _e1271;
}
let _e1275 = phi_76449_;
let _e1277 = select(_e1269, 0i, (_e1269 < 0i));
if (_e1277 >= _e951) {
phi_76460_ = (_e951 - 1i);
} else {
phi_76460_ = _e1277;
}
let _e1281 = phi_76460_;
local_38 = bitcast<i32>((_e946 * _e949));
local_39 = ((_e1281 * _e950) + _e1275);
let _e1286 = local_38;
let _e1287 = local_39;
let _e1288 = (_e1286 + _e1287);
let _e1290 = (bitcast<i32>(_e277) - 1i);
let _e1292 = select(_e1290, _e1288, (_e1288 < _e1290));
let _e1297 = global_5.member[bitcast<u32>(select(0i, _e1292, (_e1292 > 0i)))];
let _e1306 = global_1.member.member_2.member;
let _e1307 = (((((select(_e1048, _e1145, _e471) + 0.5f) / f32(_e950)) * 2f) - 1f) * _e1306);
let _e1314 = global_1.member.member_2.member_1;
let _e1315 = ((1f - (((select(_e1145, _e1048, _e471) + 0.5f) / f32(_e951)) * 2f)) * _e1314);
let _e1317 = global_1.member.member_3;
let _e1325 = global_1.member.member_4;
let _e1332 = ((_e1317.member * _e1307) + (_e1325.member * _e1315));
let _e1333 = ((_e1317.member_1 * _e1307) + (_e1325.member_1 * _e1315));
let _e1334 = ((_e1317.member_2 * _e1307) + (_e1325.member_2 * _e1315));
let _e1337 = global_1.member.member_2.member_3;
let _e1338 = (_e1337 != 0u);
let _e1340 = global_1.member.member_5;
let _e1347 = select((_e1340.member + _e1332), _e1340.member, _e1338);
let _e1348 = select((_e1340.member_1 + _e1333), _e1340.member_1, _e1338);
let _e1349 = select((_e1340.member_2 + _e1334), _e1340.member_2, _e1338);
let _e1351 = global_1.member.member_6;
let _e1365 = (((_e1347 * _e1347) + (_e1348 * _e1348)) + (_e1349 * _e1349));
let _e1368 = sqrt(select(0f, _e1365, (_e1365 > 0f)));
let _e1369 = (1f / _e1368);
let _e1370 = (_e1347 * _e1369);
let _e1371 = (_e1348 * _e1369);
let _e1372 = (_e1349 * _e1369);
let _e1373 = (_e593 - select(_e1351.member, (_e1351.member + _e1332), _e1338));
let _e1374 = (_e605 - select(_e1351.member_1, (_e1351.member_1 + _e1333), _e1338));
let _e1375 = (_e618 - select(_e1351.member_2, (_e1351.member_2 + _e1334), _e1338));
let _e1380 = (((_e1373 * _e1370) + (_e1374 * _e1371)) + (_e1375 * _e1372));
let _e1385 = (((_e1373 * _e631) + (_e1374 * _e644)) + (_e1375 * _e657));
let _e1390 = (((_e1370 * _e631) + (_e1371 * _e644)) + (_e1372 * _e657));
let _e1393 = ((_e1371 * _e657) - (_e1372 * _e644));
let _e1396 = ((_e1372 * _e631) - (_e1370 * _e657));
let _e1399 = ((_e1370 * _e644) - (_e1371 * _e631));
let _e1404 = (((_e1393 * _e1393) + (_e1396 * _e1396)) + (_e1399 * _e1399));
let _e1407 = (1f / select(1e-9f, _e1404, (_e1404 > 1e-9f)));
let _e1410 = ((_e1380 - (_e1390 * _e1385)) * _e1407);
let _e1413 = (((_e1390 * _e1380) - _e1385) * _e1407);
let _e1419 = -(_e1390);
let _e1422 = global_1.member.member_13.member_2;
let _e1423 = (_e1422 * _e1422);
let _e1427 = ((1f + _e1423) - ((2f * _e1422) * _e1419));
let _e1429 = select(1e-9f, _e1427, (_e1427 > 1e-9f));
let _e1441 = global_1.member.member_13.member_3;
if (_e1441 == 2u) {
let _e1446 = (0.5f - (0.5f * _e1419));
let _e1448 = select(0f, _e1446, (_e1446 > 0f));
let _e1452 = (sqrt(select(0f, _e1448, (_e1448 > 0f))) * 255f);
let _e1453 = (255f - 1f);
let _e1455 = select(0f, _e1452, (_e1452 > 0f));
let _e1457 = select(_e1453, _e1455, (_e1455 < _e1453));
let _e1464 = select(0i, select(select(i32(_e1457), i32(-2147483648), (_e1457 < -2147483600f)), 2147483647i, (_e1457 > 2147483500f)), (_e1457 == _e1457));
let _e1468 = (_e1464 - select(0i, 1i, (_e1457 < f32(_e1464))));
let _e1471 = global_1.member.member_13.member_11;
let _e1472 = bitcast<i32>(_e1471);
let _e1473 = (_e1472 + _e1468);
let _e1475 = (bitcast<i32>(_e283) - 1i);
let _e1477 = select(_e1475, _e1473, (_e1473 < _e1475));
let _e1482 = global_2.member[bitcast<u32>(select(0i, _e1477, (_e1477 > 0i)))];
let _e1484 = (_e1472 + (_e1468 + 1i));
let _e1486 = select(_e1475, _e1484, (_e1484 < _e1475));
let _e1491 = global_2.member[bitcast<u32>(select(0i, _e1486, (_e1486 > 0i)))];
phi_76883_ = (_e1482 + ((_e1491 - _e1482) * (_e1452 - f32(_e1468))));
} else {
phi_76883_ = select(((1f - _e1423) / (_e1429 * sqrt(select(0f, _e1429, (_e1429 > 0f))))), (0.75f * (1f + (_e1419 * _e1419))), (_e1441 == 1u));
}
let _e1498 = phi_76883_;
let _e1501 = (_e1368 * (_e1498 * (0.25f / 3.1415927f)));
let _e1502 = (_e1410 - _e1297);
let _e1505 = (_e1413 + select(0f, _e1502, (_e1502 > 0f)));
let _e1508 = global_1.member.member_13.member;
let _e1513 = -((_e1508.member * _e1505));
let _e1515 = select(-87f, _e1513, (_e1513 > -87f));
let _e1517 = select(88f, _e1515, (_e1515 < 88f));
let _e1519 = ((_e1517 * 1.442695f) + 0.5f);
let _e1521 = select(-127f, _e1519, (_e1519 > -127f));
let _e1523 = select(128f, _e1521, (_e1521 < 128f));
let _e1530 = select(0i, select(select(i32(_e1523), i32(-2147483648), (_e1523 < -2147483600f)), 2147483647i, (_e1523 > 2147483500f)), (_e1523 == _e1523));
let _e1534 = (_e1530 - select(0i, 1i, (_e1523 < f32(_e1530))));
let _e1535 = f32(_e1534);
let _e1539 = ((_e1517 - (_e1535 * 0.6933594f)) - (_e1535 * -2.1219444e-4f));
let _e1561 = -((_e1508.member_1 * _e1505));
let _e1563 = select(-87f, _e1561, (_e1561 > -87f));
let _e1565 = select(88f, _e1563, (_e1563 < 88f));
let _e1567 = ((_e1565 * 1.442695f) + 0.5f);
let _e1569 = select(-127f, _e1567, (_e1567 > -127f));
let _e1571 = select(128f, _e1569, (_e1569 < 128f));
let _e1578 = select(0i, select(select(i32(_e1571), i32(-2147483648), (_e1571 < -2147483600f)), 2147483647i, (_e1571 > 2147483500f)), (_e1571 == _e1571));
let _e1582 = (_e1578 - select(0i, 1i, (_e1571 < f32(_e1578))));
let _e1583 = f32(_e1582);
let _e1587 = ((_e1565 - (_e1583 * 0.6933594f)) - (_e1583 * -2.1219444e-4f));
let _e1609 = -((_e1508.member_2 * _e1505));
let _e1611 = select(-87f, _e1609, (_e1609 > -87f));
let _e1613 = select(88f, _e1611, (_e1611 < 88f));
let _e1615 = ((_e1613 * 1.442695f) + 0.5f);
let _e1617 = select(-127f, _e1615, (_e1615 > -127f));
let _e1619 = select(128f, _e1617, (_e1617 < 128f));
let _e1626 = select(0i, select(select(i32(_e1619), i32(-2147483648), (_e1619 < -2147483600f)), 2147483647i, (_e1619 > 2147483500f)), (_e1619 == _e1619));
let _e1630 = (_e1626 - select(0i, 1i, (_e1619 < f32(_e1626))));
let _e1631 = f32(_e1630);
let _e1635 = ((_e1613 - (_e1631 * 0.6933594f)) - (_e1631 * -2.1219444e-4f));
let _e1658 = global_1.member.member_13.member_1;
let _e1671 = select(0f, _e1410, (((_e1413 >= 0f) && (_e1413 < _e709)) && (_e1410 > 0f)));
let _e1674 = ((_e1671 > 0f) && (_e1671 < _e1240));
if _e471 {
phi_77506_ = type_26(_e1140, _e1044);
} else {
phi_77506_ = type_26(_e1044, _e1140);
}
let _e1698 = phi_77506_;
let _e1701 = (_e1141 && _e1674);
let _e1704 = global_1.member.member_18.member;
let _e1705 = (((select(_e1166, (1f - _e1166), (_e1151 >= 0f)) - select(_e1185, (1f - _e1185), (_e1170 >= 0f))) * (1f / _e1148)) * _e1704);
let _e1709 = select(0f, ((((_e670 * _e1658.member) * ((1f + (_e1539 * (1f + (_e1539 * (0.5f + (_e1539 * (0.16666667f + (_e1539 * (0.041666668f + (_e1539 * (0.008333334f + (_e1539 * (0.001388889f + (_e1539 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1534 + 127i)) << bitcast<u32>(23i))))) * _e1501) * _e1705), _e1701);
let _e1710 = select(0f, ((((_e683 * _e1658.member_1) * ((1f + (_e1587 * (1f + (_e1587 * (0.5f + (_e1587 * (0.16666667f + (_e1587 * (0.041666668f + (_e1587 * (0.008333334f + (_e1587 * (0.001388889f + (_e1587 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1582 + 127i)) << bitcast<u32>(23i))))) * _e1501) * _e1705), _e1701);
let _e1711 = select(0f, ((((_e696 * _e1658.member_2) * ((1f + (_e1635 * (1f + (_e1635 * (0.5f + (_e1635 * (0.16666667f + (_e1635 * (0.041666668f + (_e1635 * (0.008333334f + (_e1635 * (0.001388889f + (_e1635 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1630 + 127i)) << bitcast<u32>(23i))))) * _e1501) * _e1705), _e1701);
let _e1715 = (bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u)) >= 1073741800f);
let _e1716 = (1f / 1048576f);
let _e1719 = ((_e1709 * select(1f, _e1716, _e1715)) + 0.5f);
let _e1721 = select(-1073741800f, _e1719, (_e1719 > -1073741800f));
let _e1723 = select(1073741800f, _e1721, (_e1721 < 1073741800f));
let _e1730 = select(0i, select(select(i32(_e1723), i32(-2147483648), (_e1723 < -2147483600f)), 2147483647i, (_e1723 > 2147483500f)), (_e1723 == _e1723));
let _e1734 = (_e1730 - select(0i, 1i, (_e1723 < f32(_e1730))));
let _e1735 = select(0i, 20i, _e1715);
let _e1739 = (bitcast<u32>(_e1734) << bitcast<u32>((_e1735 & 31i)));
let _e1746 = bitcast<u32>(((_e1734 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1735) & 31i))));
let _e1750 = (bitcast<f32>((bitcast<u32>(_e1710) & 2147483647u)) >= 1073741800f);
let _e1753 = ((_e1710 * select(1f, _e1716, _e1750)) + 0.5f);
let _e1755 = select(-1073741800f, _e1753, (_e1753 > -1073741800f));
let _e1757 = select(1073741800f, _e1755, (_e1755 < 1073741800f));
let _e1764 = select(0i, select(select(i32(_e1757), i32(-2147483648), (_e1757 < -2147483600f)), 2147483647i, (_e1757 > 2147483500f)), (_e1757 == _e1757));
let _e1768 = (_e1764 - select(0i, 1i, (_e1757 < f32(_e1764))));
let _e1769 = select(0i, 20i, _e1750);
let _e1773 = (bitcast<u32>(_e1768) << bitcast<u32>((_e1769 & 31i)));
let _e1780 = bitcast<u32>(((_e1768 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1769) & 31i))));
let _e1784 = (bitcast<f32>((bitcast<u32>(_e1711) & 2147483647u)) >= 1073741800f);
let _e1787 = ((_e1711 * select(1f, _e1716, _e1784)) + 0.5f);
let _e1789 = select(-1073741800f, _e1787, (_e1787 > -1073741800f));
let _e1791 = select(1073741800f, _e1789, (_e1789 < 1073741800f));
let _e1798 = select(0i, select(select(i32(_e1791), i32(-2147483648), (_e1791 < -2147483600f)), 2147483647i, (_e1791 > 2147483500f)), (_e1791 == _e1791));
let _e1802 = (_e1798 - select(0i, 1i, (_e1791 < f32(_e1798))));
let _e1803 = select(0i, 20i, _e1784);
let _e1807 = (bitcast<u32>(_e1802) << bitcast<u32>((_e1803 & 31i)));
let _e1814 = bitcast<u32>(((_e1802 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1803) & 31i))));
let _e1819 = global_1.member.member_18.member_2;
let _e1822 = global_1.member.member_18.member_3;
let _e1825 = global_1.member.member_18.member_4;
let _e1828 = global_1.member.member_18.member_5;
if _e1001 {
phi_77705_ = 0u;
} else {
if (_e784 == 1u) {
phi_77704_ = _e1819;
} else {
if (_e784 == 2u) {
phi_77703_ = _e1822;
} else {
phi_77703_ = select(_e1828, _e1825, (_e784 == 3u));
}
let _e1834 = phi_77703_;
phi_77704_ = _e1834;
}
let _e1836 = phi_77704_;
phi_77705_ = _e1836;
}
let _e1838 = phi_77705_;
let _e1846 = bitcast<i32>(bitcast<u32>((((bitcast<i32>(_e1838) + (_e1698.member_1 * _e1013)) + _e1698.member) * 6i)));
if ((_e1739 | _e1746) == 0u) {
} else {
let _e1849 = bitcast<u32>(_e1846);
if (_e1849 < _e288) {
let _e1853 = atomicAdd((&global_8.member[_e1849]), _e1739);
phi_77739_ = _e1853;
} else {
phi_77739_ = 0u;
}
let _e1855 = phi_77739_;
let _e1859 = (_e1746 + select(0u, 1u, ((_e1855 + _e1739) < _e1739)));
if (_e1859 == 0u) {
} else {
let _e1861 = (_e1849 + 1u);
if (_e1861 < _e288) {
let _e1865 = atomicAdd((&global_8.member[_e1861]), _e1859);
}
}
}
if ((_e1773 | _e1780) == 0u) {
} else {
let _e1869 = bitcast<u32>((_e1846 + 2i));
if (_e1869 < _e288) {
let _e1873 = atomicAdd((&global_8.member[_e1869]), _e1773);
phi_77769_ = _e1873;
} else {
phi_77769_ = 0u;
}
let _e1875 = phi_77769_;
let _e1879 = (_e1780 + select(0u, 1u, ((_e1875 + _e1773) < _e1773)));
if (_e1879 == 0u) {
} else {
let _e1881 = (_e1869 + 1u);
if (_e1881 < _e288) {
let _e1885 = atomicAdd((&global_8.member[_e1881]), _e1879);
}
}
}
if ((_e1807 | _e1814) == 0u) {
} else {
let _e1889 = bitcast<u32>((_e1846 + 4i));
if (_e1889 < _e288) {
let _e1893 = atomicAdd((&global_8.member[_e1889]), _e1807);
phi_77799_ = _e1893;
} else {
phi_77799_ = 0u;
}
let _e1895 = phi_77799_;
let _e1899 = (_e1814 + select(0u, 1u, ((_e1895 + _e1807) < _e1807)));
if (_e1899 == 0u) {
} else {
let _e1901 = (_e1889 + 1u);
if (_e1901 < _e288) {
let _e1905 = atomicAdd((&global_8.member[_e1901]), _e1899);
}
}
}
let _e1906 = bitcast<i32>(bitcast<u32>(select(-1i, _e1140, (_e1141 && (!(((_e1674 && !(((((_e1044 * _e1036) == _e316) && (_e863 != _e784)) || ((((_e1044 + 1i) * _e1036) == _e710) && (_e941 != _e784))))) && ((_e1671 * (1f + (0.02f * _e1037))) < _e1261))) && (_e1671 <= _e1250))))));
if (_e1906 >= 0i) {
phi_77836_ = type_26(select(_e1135.member, _e1906, (_e1906 < _e1135.member)), select(_e1135.member_1, _e1906, (_e1906 > _e1135.member_1)));
} else {
phi_77836_ = _e1135;
}
let _e1916 = phi_77836_;
phi_76140_ = _e1916;
phi_76143_ = (_e1137 + 1i);
} else {
phi_76140_ = type_26();
phi_76143_ = i32();
}
let _e1919 = phi_76140_;
let _e1921 = phi_76143_;
continue;
continuing {
phi_76139_ = _e1919;
phi_76142_ = _e1921;
break if !(_e1141);
}
}
let _e27189 = local_254;
phi_75986_ = _e27189;
phi_75989_ = (_e1033 + 1i);
} else {
phi_75986_ = type_26();
phi_75989_ = i32();
}
let _e1925 = phi_75986_;
let _e1927 = phi_75989_;
continue;
continuing {
phi_75985_ = _e1925;
phi_75988_ = _e1927;
break if !(_e1034);
}
}
let _e1930 = local_241;
let _e1933 = local_242;
if (_e1930.member <= _e1933.member_1) {
let _e1938 = ((_e1933.member_1 + 1i) << bitcast<u32>(_e1002));
if (_e1938 <= _e1000) {
phi_77853_ = (_e1938 - 1i);
} else {
phi_77853_ = _e1000;
}
let _e1942 = phi_77853_;
let _e1944 = (_e1930.member << bitcast<u32>(_e1002));
let _e1946 = select(_e863, 0u, (_e863 == _e784));
let _e1950 = select(_e941, 0u, ((_e941 == _e784) || (_e941 == _e863)));
let _e1958 = ((select(0u, 1u, (_e784 > 0u)) + select(0u, 1u, (_e1946 > 0u))) + select(0u, 1u, (_e1950 > 0u)));
if (_e1958 == 0u) {
phi_77888_ = 0i;
loop {
let _e6178 = phi_77888_;
let _e6179 = (_e6178 < 16i);
if _e6179 {
let _e6181 = (_e995 + (_e6178 & 15i));
let _e6185 = (((f32(_e6181) + 0.5f) * 1f) - 0.5f);
let _e6189 = (-(((_e434 * _e6185) + _e460)) / _e447);
let _e6196 = bitcast<f32>((bitcast<u32>(((_e484 * _e6185) + ((_e497 * _e6189) + _e510))) & 2147483647u));
let _e6203 = bitcast<f32>((bitcast<u32>(((_e523 * _e6185) + ((_e536 * _e6189) + _e549))) & 2147483647u));
let _e6207 = (((0.5f * (_e6196 + _e6203)) / _e552) + _e735);
let _e6208 = (1f / 1f);
let _e6216 = ((((_e6189 + _e6207) + 0.5f) * _e6208) - 0.5f);
let _e6217 = f32(_e1944);
let _e6218 = f32(_e1942);
let _e6219 = (_e6217 - 1f);
let _e6221 = select(_e6219, _e6216, (_e6216 > _e6219));
let _e6223 = select(_e6218, _e6221, (_e6221 < _e6218));
let _e6230 = select(0i, select(select(i32(_e6223), i32(-2147483648), (_e6223 < -2147483600f)), 2147483647i, (_e6223 > 2147483500f)), (_e6223 == _e6223));
let _e6235 = (((((_e6189 - _e6207) + 0.5f) * _e6208) - 0.5f) + 1f);
let _e6236 = (_e6218 + 1f);
let _e6238 = select(_e6217, _e6235, (_e6235 > _e6217));
let _e6240 = select(_e6236, _e6238, (_e6238 < _e6236));
let _e6247 = select(0i, select(select(i32(_e6240), i32(-2147483648), (_e6240 < -2147483600f)), 2147483647i, (_e6240 > 2147483500f)), (_e6240 == _e6240));
let _e6258 = ((1e-4f * 1f) * _e552);
let _e6260 = select(_e6203, _e6196, (_e6196 > _e6203));
let _e6262 = select(_e6258, _e6260, (_e6260 > _e6258));
let _e6264 = select(_e6203, _e6196, (_e6196 < _e6203));
let _e6266 = select(_e6258, _e6264, (_e6264 > _e6258));
let _e6268 = (0.5f * (_e6262 + _e6266));
let _e6269 = (0.5f / _e6266);
let _e6270 = (1f / _e6262);
phi_78042_ = 0i;
loop {
let _e6272 = phi_78042_;
let _e6274 = (((_e6247 - select(0i, 1i, (_e6240 < f32(_e6247)))) + (_e6178 >> bitcast<u32>(4u))) + bitcast<i32>(_e6272));
let _e6275 = (_e6274 <= select(-1i, (_e6230 - select(0i, 1i, (_e6223 < f32(_e6230)))), (_e6181 <= _e999)));
if _e6275 {
let _e6281 = (((((f32(_e6274) + 0.5f) * 1f) - 0.5f) - _e6189) * _e552);
let _e6282 = (_e552 * 1f);
let _e6284 = (0.5f * _e6282);
let _e6285 = (_e6281 + _e6284);
let _e6286 = -(_e6285);
let _e6289 = (_e6268 - select(_e6286, _e6285, (_e6285 > _e6286)));
let _e6291 = select(0f, _e6289, (_e6289 > 0f));
let _e6293 = select(_e6266, _e6291, (_e6291 < _e6266));
let _e6296 = (_e6289 - _e6266);
let _e6300 = (((_e6293 * (_e6293 * _e6269)) + select(0f, _e6296, (_e6296 > 0f))) * _e6270);
let _e6304 = (_e6281 - _e6284);
let _e6305 = -(_e6304);
let _e6308 = (_e6268 - select(_e6305, _e6304, (_e6304 > _e6305)));
let _e6310 = select(0f, _e6308, (_e6308 > 0f));
let _e6312 = select(_e6266, _e6310, (_e6310 < _e6266));
let _e6315 = (_e6308 - _e6266);
let _e6319 = (((_e6312 * (_e6312 * _e6269)) + select(0f, _e6315, (_e6315 > 0f))) * _e6270);
if _e471 {
phi_78147_ = type_26(_e6274, _e6181);
} else {
phi_78147_ = type_26(_e6181, _e6274);
}
let _e6328 = phi_78147_;
local_36 = bitcast<i32>((_e946 * _e949));
local_37 = ((_e6328.member_1 * _e950) + _e6328.member);
let _e6335 = local_36;
let _e6336 = local_37;
let _e6337 = (_e6335 + _e6336);
let _e6339 = (bitcast<i32>(_e277) - 1i);
let _e6341 = select(_e6339, _e6337, (_e6337 < _e6339));
let _e6346 = global_5.member[bitcast<u32>(select(0i, _e6341, (_e6341 > 0i)))];
let _e6347 = local_37;
let _e6349 = select(_e6339, _e6347, (_e6347 < _e6339));
let _e6354 = global_5.member[bitcast<u32>(select(0i, _e6349, (_e6349 > 0i)))];
let _e6365 = global_1.member.member_2.member;
let _e6366 = (((((f32(_e6328.member) + 0.5f) / f32(_e950)) * 2f) - 1f) * _e6365);
let _e6373 = global_1.member.member_2.member_1;
let _e6374 = ((1f - (((f32(_e6328.member_1) + 0.5f) / f32(_e951)) * 2f)) * _e6373);
let _e6376 = global_1.member.member_3;
let _e6384 = global_1.member.member_4;
let _e6391 = ((_e6376.member * _e6366) + (_e6384.member * _e6374));
let _e6392 = ((_e6376.member_1 * _e6366) + (_e6384.member_1 * _e6374));
let _e6393 = ((_e6376.member_2 * _e6366) + (_e6384.member_2 * _e6374));
let _e6396 = global_1.member.member_2.member_3;
let _e6397 = (_e6396 != 0u);
let _e6399 = global_1.member.member_5;
let _e6406 = select((_e6399.member + _e6391), _e6399.member, _e6397);
let _e6407 = select((_e6399.member_1 + _e6392), _e6399.member_1, _e6397);
let _e6408 = select((_e6399.member_2 + _e6393), _e6399.member_2, _e6397);
let _e6410 = global_1.member.member_6;
let _e6424 = (((_e6406 * _e6406) + (_e6407 * _e6407)) + (_e6408 * _e6408));
let _e6427 = sqrt(select(0f, _e6424, (_e6424 > 0f)));
let _e6428 = (1f / _e6427);
let _e6429 = (_e6406 * _e6428);
let _e6430 = (_e6407 * _e6428);
let _e6431 = (_e6408 * _e6428);
let _e6432 = (_e593 - select(_e6410.member, (_e6410.member + _e6391), _e6397));
let _e6433 = (_e605 - select(_e6410.member_1, (_e6410.member_1 + _e6392), _e6397));
let _e6434 = (_e618 - select(_e6410.member_2, (_e6410.member_2 + _e6393), _e6397));
let _e6439 = (((_e6432 * _e6429) + (_e6433 * _e6430)) + (_e6434 * _e6431));
let _e6444 = (((_e6432 * _e631) + (_e6433 * _e644)) + (_e6434 * _e657));
let _e6449 = (((_e6429 * _e631) + (_e6430 * _e644)) + (_e6431 * _e657));
let _e6452 = ((_e6430 * _e657) - (_e6431 * _e644));
let _e6455 = ((_e6431 * _e631) - (_e6429 * _e657));
let _e6458 = ((_e6429 * _e644) - (_e6430 * _e631));
let _e6463 = (((_e6452 * _e6452) + (_e6455 * _e6455)) + (_e6458 * _e6458));
let _e6466 = (1f / select(1e-9f, _e6463, (_e6463 > 1e-9f)));
let _e6469 = ((_e6439 - (_e6449 * _e6444)) * _e6466);
let _e6472 = (((_e6449 * _e6439) - _e6444) * _e6466);
let _e6478 = -(_e6449);
let _e6481 = global_1.member.member_13.member_2;
let _e6482 = (_e6481 * _e6481);
let _e6486 = ((1f + _e6482) - ((2f * _e6481) * _e6478));
let _e6488 = select(1e-9f, _e6486, (_e6486 > 1e-9f));
let _e6500 = global_1.member.member_13.member_3;
if (_e6500 == 2u) {
let _e6505 = (0.5f - (0.5f * _e6478));
let _e6507 = select(0f, _e6505, (_e6505 > 0f));
let _e6511 = (sqrt(select(0f, _e6507, (_e6507 > 0f))) * 255f);
let _e6512 = (255f - 1f);
let _e6514 = select(0f, _e6511, (_e6511 > 0f));
let _e6516 = select(_e6512, _e6514, (_e6514 < _e6512));
let _e6523 = select(0i, select(select(i32(_e6516), i32(-2147483648), (_e6516 < -2147483600f)), 2147483647i, (_e6516 > 2147483500f)), (_e6516 == _e6516));
let _e6527 = (_e6523 - select(0i, 1i, (_e6516 < f32(_e6523))));
let _e6530 = global_1.member.member_13.member_11;
let _e6531 = bitcast<i32>(_e6530);
let _e6532 = (_e6531 + _e6527);
let _e6534 = (bitcast<i32>(_e283) - 1i);
let _e6536 = select(_e6534, _e6532, (_e6532 < _e6534));
let _e6541 = global_2.member[bitcast<u32>(select(0i, _e6536, (_e6536 > 0i)))];
let _e6543 = (_e6531 + (_e6527 + 1i));
let _e6545 = select(_e6534, _e6543, (_e6543 < _e6534));
let _e6550 = global_2.member[bitcast<u32>(select(0i, _e6545, (_e6545 > 0i)))];
phi_78574_ = (_e6541 + ((_e6550 - _e6541) * (_e6511 - f32(_e6527))));
} else {
phi_78574_ = select(((1f - _e6482) / (_e6488 * sqrt(select(0f, _e6488, (_e6488 > 0f))))), (0.75f * (1f + (_e6478 * _e6478))), (_e6500 == 1u));
}
let _e6557 = phi_78574_;
let _e6560 = (_e6427 * (_e6557 * (0.25f / 3.1415927f)));
let _e6561 = (_e6469 - _e6346);
let _e6564 = (_e6472 + select(0f, _e6561, (_e6561 > 0f)));
let _e6567 = global_1.member.member_13.member;
let _e6572 = -((_e6567.member * _e6564));
let _e6574 = select(-87f, _e6572, (_e6572 > -87f));
let _e6576 = select(88f, _e6574, (_e6574 < 88f));
let _e6578 = ((_e6576 * 1.442695f) + 0.5f);
let _e6580 = select(-127f, _e6578, (_e6578 > -127f));
let _e6582 = select(128f, _e6580, (_e6580 < 128f));
let _e6589 = select(0i, select(select(i32(_e6582), i32(-2147483648), (_e6582 < -2147483600f)), 2147483647i, (_e6582 > 2147483500f)), (_e6582 == _e6582));
let _e6593 = (_e6589 - select(0i, 1i, (_e6582 < f32(_e6589))));
let _e6594 = f32(_e6593);
let _e6598 = ((_e6576 - (_e6594 * 0.6933594f)) - (_e6594 * -2.1219444e-4f));
let _e6620 = -((_e6567.member_1 * _e6564));
let _e6622 = select(-87f, _e6620, (_e6620 > -87f));
let _e6624 = select(88f, _e6622, (_e6622 < 88f));
let _e6626 = ((_e6624 * 1.442695f) + 0.5f);
let _e6628 = select(-127f, _e6626, (_e6626 > -127f));
let _e6630 = select(128f, _e6628, (_e6628 < 128f));
let _e6637 = select(0i, select(select(i32(_e6630), i32(-2147483648), (_e6630 < -2147483600f)), 2147483647i, (_e6630 > 2147483500f)), (_e6630 == _e6630));
let _e6641 = (_e6637 - select(0i, 1i, (_e6630 < f32(_e6637))));
let _e6642 = f32(_e6641);
let _e6646 = ((_e6624 - (_e6642 * 0.6933594f)) - (_e6642 * -2.1219444e-4f));
let _e6668 = -((_e6567.member_2 * _e6564));
let _e6670 = select(-87f, _e6668, (_e6668 > -87f));
let _e6672 = select(88f, _e6670, (_e6670 < 88f));
let _e6674 = ((_e6672 * 1.442695f) + 0.5f);
let _e6676 = select(-127f, _e6674, (_e6674 > -127f));
let _e6678 = select(128f, _e6676, (_e6676 < 128f));
let _e6685 = select(0i, select(select(i32(_e6678), i32(-2147483648), (_e6678 < -2147483600f)), 2147483647i, (_e6678 > 2147483500f)), (_e6678 == _e6678));
let _e6689 = (_e6685 - select(0i, 1i, (_e6678 < f32(_e6685))));
let _e6690 = f32(_e6689);
let _e6694 = ((_e6672 - (_e6690 * 0.6933594f)) - (_e6690 * -2.1219444e-4f));
let _e6717 = global_1.member.member_13.member_1;
let _e6730 = select(0f, _e6469, (((_e6472 >= 0f) && (_e6472 < _e709)) && (_e6469 > 0f)));
if _e471 {
phi_79176_ = type_26(_e6274, _e6181);
} else {
phi_79176_ = type_26(_e6181, _e6274);
}
let _e6741 = phi_79176_;
let _e6744 = (_e6275 && (((_e6730 > 0f) && (_e6730 < _e6354)) && true));
let _e6747 = global_1.member.member_18.member;
let _e6748 = (((select(_e6300, (1f - _e6300), (_e6285 >= 0f)) - select(_e6319, (1f - _e6319), (_e6304 >= 0f))) * (1f / _e6282)) * _e6747);
let _e6752 = select(0f, (((((_e670 * _e6717.member) * ((1f + (_e6598 * (1f + (_e6598 * (0.5f + (_e6598 * (0.16666667f + (_e6598 * (0.041666668f + (_e6598 * (0.008333334f + (_e6598 * (0.001388889f + (_e6598 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6593 + 127i)) << bitcast<u32>(23i))))) * _e6560) * 1f) * _e6748), _e6744);
let _e6753 = select(0f, (((((_e683 * _e6717.member_1) * ((1f + (_e6646 * (1f + (_e6646 * (0.5f + (_e6646 * (0.16666667f + (_e6646 * (0.041666668f + (_e6646 * (0.008333334f + (_e6646 * (0.001388889f + (_e6646 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6641 + 127i)) << bitcast<u32>(23i))))) * _e6560) * 1f) * _e6748), _e6744);
let _e6754 = select(0f, (((((_e696 * _e6717.member_2) * ((1f + (_e6694 * (1f + (_e6694 * (0.5f + (_e6694 * (0.16666667f + (_e6694 * (0.041666668f + (_e6694 * (0.008333334f + (_e6694 * (0.001388889f + (_e6694 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6689 + 127i)) << bitcast<u32>(23i))))) * _e6560) * 1f) * _e6748), _e6744);
let _e6758 = (bitcast<f32>((bitcast<u32>(_e6752) & 2147483647u)) >= 1073741800f);
let _e6759 = (1f / 1048576f);
let _e6762 = ((_e6752 * select(1f, _e6759, _e6758)) + 0.5f);
let _e6764 = select(-1073741800f, _e6762, (_e6762 > -1073741800f));
let _e6766 = select(1073741800f, _e6764, (_e6764 < 1073741800f));
let _e6773 = select(0i, select(select(i32(_e6766), i32(-2147483648), (_e6766 < -2147483600f)), 2147483647i, (_e6766 > 2147483500f)), (_e6766 == _e6766));
let _e6777 = (_e6773 - select(0i, 1i, (_e6766 < f32(_e6773))));
let _e6778 = select(0i, 20i, _e6758);
let _e6782 = (bitcast<u32>(_e6777) << bitcast<u32>((_e6778 & 31i)));
let _e6789 = bitcast<u32>(((_e6777 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6778) & 31i))));
let _e6793 = (bitcast<f32>((bitcast<u32>(_e6753) & 2147483647u)) >= 1073741800f);
let _e6796 = ((_e6753 * select(1f, _e6759, _e6793)) + 0.5f);
let _e6798 = select(-1073741800f, _e6796, (_e6796 > -1073741800f));
let _e6800 = select(1073741800f, _e6798, (_e6798 < 1073741800f));
let _e6807 = select(0i, select(select(i32(_e6800), i32(-2147483648), (_e6800 < -2147483600f)), 2147483647i, (_e6800 > 2147483500f)), (_e6800 == _e6800));
let _e6811 = (_e6807 - select(0i, 1i, (_e6800 < f32(_e6807))));
let _e6812 = select(0i, 20i, _e6793);
let _e6816 = (bitcast<u32>(_e6811) << bitcast<u32>((_e6812 & 31i)));
let _e6823 = bitcast<u32>(((_e6811 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6812) & 31i))));
let _e6827 = (bitcast<f32>((bitcast<u32>(_e6754) & 2147483647u)) >= 1073741800f);
let _e6830 = ((_e6754 * select(1f, _e6759, _e6827)) + 0.5f);
let _e6832 = select(-1073741800f, _e6830, (_e6830 > -1073741800f));
let _e6834 = select(1073741800f, _e6832, (_e6832 < 1073741800f));
let _e6841 = select(0i, select(select(i32(_e6834), i32(-2147483648), (_e6834 < -2147483600f)), 2147483647i, (_e6834 > 2147483500f)), (_e6834 == _e6834));
let _e6845 = (_e6841 - select(0i, 1i, (_e6834 < f32(_e6841))));
let _e6846 = select(0i, 20i, _e6827);
let _e6850 = (bitcast<u32>(_e6845) << bitcast<u32>((_e6846 & 31i)));
let _e6857 = bitcast<u32>(((_e6845 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6846) & 31i))));
let _e6862 = bitcast<i32>(bitcast<u32>((((_e6741.member_1 * _e950) + _e6741.member) * 6i)));
if ((_e6782 | _e6789) == 0u) {
} else {
let _e6865 = bitcast<u32>(_e6862);
if (_e6865 < _e288) {
let _e6869 = atomicAdd((&global_8.member[_e6865]), _e6782);
phi_79409_ = _e6869;
} else {
phi_79409_ = 0u;
}
let _e6871 = phi_79409_;
let _e6875 = (_e6789 + select(0u, 1u, ((_e6871 + _e6782) < _e6782)));
if (_e6875 == 0u) {
} else {
let _e6877 = (_e6865 + 1u);
if (_e6877 < _e288) {
let _e6881 = atomicAdd((&global_8.member[_e6877]), _e6875);
}
}
}
if ((_e6816 | _e6823) == 0u) {
} else {
let _e6885 = bitcast<u32>((_e6862 + 2i));
if (_e6885 < _e288) {
let _e6889 = atomicAdd((&global_8.member[_e6885]), _e6816);
phi_79439_ = _e6889;
} else {
phi_79439_ = 0u;
}
let _e6891 = phi_79439_;
let _e6895 = (_e6823 + select(0u, 1u, ((_e6891 + _e6816) < _e6816)));
if (_e6895 == 0u) {
} else {
let _e6897 = (_e6885 + 1u);
if (_e6897 < _e288) {
let _e6901 = atomicAdd((&global_8.member[_e6897]), _e6895);
}
}
}
if ((_e6850 | _e6857) == 0u) {
} else {
let _e6905 = bitcast<u32>((_e6862 + 4i));
if (_e6905 < _e288) {
let _e6909 = atomicAdd((&global_8.member[_e6905]), _e6850);
phi_79469_ = _e6909;
} else {
phi_79469_ = 0u;
}
let _e6911 = phi_79469_;
let _e6915 = (_e6857 + select(0u, 1u, ((_e6911 + _e6850) < _e6850)));
if (_e6915 == 0u) {
} else {
let _e6917 = (_e6905 + 1u);
if (_e6917 < _e288) {
let _e6921 = atomicAdd((&global_8.member[_e6917]), _e6915);
}
}
}
phi_78043_ = (_e6272 + 1i);
} else {
phi_78043_ = i32();
}
let _e6924 = phi_78043_;
continue;
continuing {
phi_78042_ = _e6924;
break if !(_e6275);
}
}
phi_77889_ = (_e6178 + 1i);
} else {
phi_77889_ = i32();
}
let _e6928 = phi_77889_;
continue;
continuing {
phi_77888_ = _e6928;
break if !(_e6179);
}
}
} else {
if (_e1958 == 1u) {
phi_79518_ = 0i;
loop {
let _e4733 = phi_79518_;
let _e4734 = (_e4733 < 16i);
if _e4734 {
let _e4736 = (_e995 + (_e4733 & 15i));
let _e4738 = (f32(_e4736) + 0.5f);
let _e4740 = ((_e4738 * 1f) - 0.5f);
let _e4744 = (-(((_e434 * _e4740) + _e460)) / _e447);
let _e4751 = bitcast<f32>((bitcast<u32>(((_e484 * _e4740) + ((_e497 * _e4744) + _e510))) & 2147483647u));
let _e4758 = bitcast<f32>((bitcast<u32>(((_e523 * _e4740) + ((_e536 * _e4744) + _e549))) & 2147483647u));
let _e4762 = (((0.5f * (_e4751 + _e4758)) / _e552) + _e735);
let _e4763 = (1f / 1f);
let _e4771 = ((((_e4744 + _e4762) + 0.5f) * _e4763) - 0.5f);
let _e4772 = f32(_e1944);
let _e4773 = f32(_e1942);
let _e4774 = (_e4772 - 1f);
let _e4776 = select(_e4774, _e4771, (_e4771 > _e4774));
let _e4778 = select(_e4773, _e4776, (_e4776 < _e4773));
let _e4785 = select(0i, select(select(i32(_e4778), i32(-2147483648), (_e4778 < -2147483600f)), 2147483647i, (_e4778 > 2147483500f)), (_e4778 == _e4778));
let _e4790 = (((((_e4744 - _e4762) + 0.5f) * _e4763) - 0.5f) + 1f);
let _e4791 = (_e4773 + 1f);
let _e4793 = select(_e4772, _e4790, (_e4790 > _e4772));
let _e4795 = select(_e4791, _e4793, (_e4793 < _e4791));
let _e4802 = select(0i, select(select(i32(_e4795), i32(-2147483648), (_e4795 < -2147483600f)), 2147483647i, (_e4795 > 2147483500f)), (_e4795 == _e4795));
let _e4813 = ((1e-4f * 1f) * _e552);
let _e4815 = select(_e4758, _e4751, (_e4751 > _e4758));
let _e4817 = select(_e4813, _e4815, (_e4815 > _e4813));
let _e4819 = select(_e4758, _e4751, (_e4751 < _e4758));
let _e4821 = select(_e4813, _e4819, (_e4819 > _e4813));
let _e4823 = (0.5f * (_e4817 + _e4821));
let _e4824 = (0.5f / _e4821);
let _e4825 = (1f / _e4817);
phi_79672_ = 0i;
loop {
let _e4827 = phi_79672_;
let _e4829 = (((_e4802 - select(0i, 1i, (_e4795 < f32(_e4802)))) + (_e4733 >> bitcast<u32>(4u))) + bitcast<i32>(_e4827));
let _e4830 = (_e4829 <= select(-1i, (_e4785 - select(0i, 1i, (_e4778 < f32(_e4785)))), (_e4736 <= _e999)));
if _e4830 {
let _e4832 = (f32(_e4829) + 0.5f);
let _e4836 = ((((_e4832 * 1f) - 0.5f) - _e4744) * _e552);
let _e4837 = (_e552 * 1f);
let _e4839 = (0.5f * _e4837);
let _e4840 = (_e4836 + _e4839);
let _e4841 = -(_e4840);
let _e4844 = (_e4823 - select(_e4841, _e4840, (_e4840 > _e4841)));
let _e4846 = select(0f, _e4844, (_e4844 > 0f));
let _e4848 = select(_e4821, _e4846, (_e4846 < _e4821));
let _e4851 = (_e4844 - _e4821);
let _e4855 = (((_e4848 * (_e4848 * _e4824)) + select(0f, _e4851, (_e4851 > 0f))) * _e4825);
let _e4859 = (_e4836 - _e4839);
let _e4860 = -(_e4859);
let _e4863 = (_e4823 - select(_e4860, _e4859, (_e4859 > _e4860)));
let _e4865 = select(0f, _e4863, (_e4863 > 0f));
let _e4867 = select(_e4821, _e4865, (_e4865 < _e4821));
let _e4870 = (_e4863 - _e4821);
let _e4874 = (((_e4867 * (_e4867 * _e4824)) + select(0f, _e4870, (_e4870 > 0f))) * _e4825);
if _e471 {
phi_79777_ = type_26(_e4829, _e4736);
} else {
phi_79777_ = type_26(_e4736, _e4829);
}
let _e4883 = phi_79777_;
local_34 = bitcast<i32>((_e946 * _e949));
local_35 = ((_e4883.member_1 * _e950) + _e4883.member);
let _e4890 = local_34;
let _e4891 = local_35;
let _e4892 = (_e4890 + _e4891);
let _e4894 = (bitcast<i32>(_e277) - 1i);
let _e4896 = select(_e4894, _e4892, (_e4892 < _e4894));
let _e4901 = global_5.member[bitcast<u32>(select(0i, _e4896, (_e4896 > 0i)))];
let _e4902 = local_35;
let _e4904 = select(_e4894, _e4902, (_e4902 < _e4894));
let _e4909 = global_5.member[bitcast<u32>(select(0i, _e4904, (_e4904 > 0i)))];
let _e4912 = f32(_e950);
let _e4913 = f32(_e951);
let _e4920 = global_1.member.member_2.member;
let _e4921 = (((((f32(_e4883.member) + 0.5f) / _e4912) * 2f) - 1f) * _e4920);
let _e4928 = global_1.member.member_2.member_1;
let _e4929 = ((1f - (((f32(_e4883.member_1) + 0.5f) / _e4913) * 2f)) * _e4928);
let _e4931 = global_1.member.member_3;
let _e4939 = global_1.member.member_4;
let _e4946 = ((_e4931.member * _e4921) + (_e4939.member * _e4929));
let _e4947 = ((_e4931.member_1 * _e4921) + (_e4939.member_1 * _e4929));
let _e4948 = ((_e4931.member_2 * _e4921) + (_e4939.member_2 * _e4929));
let _e4951 = global_1.member.member_2.member_3;
let _e4952 = (_e4951 != 0u);
let _e4954 = global_1.member.member_5;
let _e4961 = select((_e4954.member + _e4946), _e4954.member, _e4952);
let _e4962 = select((_e4954.member_1 + _e4947), _e4954.member_1, _e4952);
let _e4963 = select((_e4954.member_2 + _e4948), _e4954.member_2, _e4952);
let _e4965 = global_1.member.member_6;
let _e4979 = (((_e4961 * _e4961) + (_e4962 * _e4962)) + (_e4963 * _e4963));
let _e4982 = sqrt(select(0f, _e4979, (_e4979 > 0f)));
let _e4983 = (1f / _e4982);
let _e4984 = (_e4961 * _e4983);
let _e4985 = (_e4962 * _e4983);
let _e4986 = (_e4963 * _e4983);
let _e4987 = (_e593 - select(_e4965.member, (_e4965.member + _e4946), _e4952));
let _e4988 = (_e605 - select(_e4965.member_1, (_e4965.member_1 + _e4947), _e4952));
let _e4989 = (_e618 - select(_e4965.member_2, (_e4965.member_2 + _e4948), _e4952));
let _e4994 = (((_e4987 * _e4984) + (_e4988 * _e4985)) + (_e4989 * _e4986));
let _e4999 = (((_e4987 * _e631) + (_e4988 * _e644)) + (_e4989 * _e657));
let _e5004 = (((_e4984 * _e631) + (_e4985 * _e644)) + (_e4986 * _e657));
let _e5007 = ((_e4985 * _e657) - (_e4986 * _e644));
let _e5010 = ((_e4986 * _e631) - (_e4984 * _e657));
let _e5013 = ((_e4984 * _e644) - (_e4985 * _e631));
let _e5018 = (((_e5007 * _e5007) + (_e5010 * _e5010)) + (_e5013 * _e5013));
let _e5021 = (1f / select(1e-9f, _e5018, (_e5018 > 1e-9f)));
let _e5024 = ((_e4994 - (_e5004 * _e4999)) * _e5021);
let _e5027 = (((_e5004 * _e4994) - _e4999) * _e5021);
let _e5033 = -(_e5004);
let _e5036 = global_1.member.member_13.member_2;
let _e5037 = (_e5036 * _e5036);
let _e5041 = ((1f + _e5037) - ((2f * _e5036) * _e5033));
let _e5043 = select(1e-9f, _e5041, (_e5041 > 1e-9f));
let _e5055 = global_1.member.member_13.member_3;
if (_e5055 == 2u) {
let _e5060 = (0.5f - (0.5f * _e5033));
let _e5062 = select(0f, _e5060, (_e5060 > 0f));
let _e5066 = (sqrt(select(0f, _e5062, (_e5062 > 0f))) * 255f);
let _e5067 = (255f - 1f);
let _e5069 = select(0f, _e5066, (_e5066 > 0f));
let _e5071 = select(_e5067, _e5069, (_e5069 < _e5067));
let _e5078 = select(0i, select(select(i32(_e5071), i32(-2147483648), (_e5071 < -2147483600f)), 2147483647i, (_e5071 > 2147483500f)), (_e5071 == _e5071));
let _e5082 = (_e5078 - select(0i, 1i, (_e5071 < f32(_e5078))));
let _e5085 = global_1.member.member_13.member_11;
let _e5086 = bitcast<i32>(_e5085);
let _e5087 = (_e5086 + _e5082);
let _e5089 = (bitcast<i32>(_e283) - 1i);
let _e5091 = select(_e5089, _e5087, (_e5087 < _e5089));
let _e5096 = global_2.member[bitcast<u32>(select(0i, _e5091, (_e5091 > 0i)))];
let _e5098 = (_e5086 + (_e5082 + 1i));
let _e5100 = select(_e5089, _e5098, (_e5098 < _e5089));
let _e5105 = global_2.member[bitcast<u32>(select(0i, _e5100, (_e5100 > 0i)))];
phi_80204_ = (_e5096 + ((_e5105 - _e5096) * (_e5066 - f32(_e5082))));
} else {
phi_80204_ = select(((1f - _e5037) / (_e5043 * sqrt(select(0f, _e5043, (_e5043 > 0f))))), (0.75f * (1f + (_e5033 * _e5033))), (_e5055 == 1u));
}
let _e5112 = phi_80204_;
let _e5115 = (_e4982 * (_e5112 * (0.25f / 3.1415927f)));
let _e5116 = (_e5024 - _e4901);
let _e5119 = (_e5027 + select(0f, _e5116, (_e5116 > 0f)));
let _e5122 = global_1.member.member_13.member;
let _e5127 = -((_e5122.member * _e5119));
let _e5129 = select(-87f, _e5127, (_e5127 > -87f));
let _e5131 = select(88f, _e5129, (_e5129 < 88f));
let _e5133 = ((_e5131 * 1.442695f) + 0.5f);
let _e5135 = select(-127f, _e5133, (_e5133 > -127f));
let _e5137 = select(128f, _e5135, (_e5135 < 128f));
let _e5144 = select(0i, select(select(i32(_e5137), i32(-2147483648), (_e5137 < -2147483600f)), 2147483647i, (_e5137 > 2147483500f)), (_e5137 == _e5137));
let _e5148 = (_e5144 - select(0i, 1i, (_e5137 < f32(_e5144))));
let _e5149 = f32(_e5148);
let _e5153 = ((_e5131 - (_e5149 * 0.6933594f)) - (_e5149 * -2.1219444e-4f));
let _e5175 = -((_e5122.member_1 * _e5119));
let _e5177 = select(-87f, _e5175, (_e5175 > -87f));
let _e5179 = select(88f, _e5177, (_e5177 < 88f));
let _e5181 = ((_e5179 * 1.442695f) + 0.5f);
let _e5183 = select(-127f, _e5181, (_e5181 > -127f));
let _e5185 = select(128f, _e5183, (_e5183 < 128f));
let _e5192 = select(0i, select(select(i32(_e5185), i32(-2147483648), (_e5185 < -2147483600f)), 2147483647i, (_e5185 > 2147483500f)), (_e5185 == _e5185));
let _e5196 = (_e5192 - select(0i, 1i, (_e5185 < f32(_e5192))));
let _e5197 = f32(_e5196);
let _e5201 = ((_e5179 - (_e5197 * 0.6933594f)) - (_e5197 * -2.1219444e-4f));
let _e5223 = -((_e5122.member_2 * _e5119));
let _e5225 = select(-87f, _e5223, (_e5223 > -87f));
let _e5227 = select(88f, _e5225, (_e5225 < 88f));
let _e5229 = ((_e5227 * 1.442695f) + 0.5f);
let _e5231 = select(-127f, _e5229, (_e5229 > -127f));
let _e5233 = select(128f, _e5231, (_e5231 < 128f));
let _e5240 = select(0i, select(select(i32(_e5233), i32(-2147483648), (_e5233 < -2147483600f)), 2147483647i, (_e5233 > 2147483500f)), (_e5233 == _e5233));
let _e5244 = (_e5240 - select(0i, 1i, (_e5233 < f32(_e5240))));
let _e5245 = f32(_e5244);
let _e5249 = ((_e5227 - (_e5245 * 0.6933594f)) - (_e5245 * -2.1219444e-4f));
let _e5272 = global_1.member.member_13.member_1;
let _e5285 = select(0f, _e5024, (((_e5027 >= 0f) && (_e5027 < _e709)) && (_e5024 > 0f)));
let _e5287 = ((_e784 + _e1946) + _e1950);
let _e5288 = (_e5287 & 31u);
let _e5290 = (1u << bitcast<u32>(_e5288));
let _e5299 = bitcast<i32>((((_e946 + _e5290) - 1u) >> bitcast<u32>(_e5288)));
let _e5300 = bitcast<i32>((((_e949 + _e5290) - 1u) >> bitcast<u32>(_e5288)));
if _e471 {
phi_80832_ = type_26(_e5300, _e5299);
} else {
phi_80832_ = type_26(_e5299, _e5300);
}
let _e5304 = phi_80832_;
let _e5309 = f32((1i << bitcast<u32>(_e5288)));
let _e5310 = (1f / _e5309);
let _e5312 = ((_e4738 * _e5310) - 0.5f);
let _e5314 = ((_e4832 * _e5310) - 0.5f);
let _e5316 = select(-1f, _e5312, (_e5312 > -1f));
let _e5318 = select(1e6f, _e5316, (_e5316 < 1e6f));
let _e5325 = select(0i, select(select(i32(_e5318), i32(-2147483648), (_e5318 < -2147483600f)), 2147483647i, (_e5318 > 2147483500f)), (_e5318 == _e5318));
let _e5329 = (_e5325 - select(0i, 1i, (_e5318 < f32(_e5325))));
let _e5331 = select(-1f, _e5314, (_e5314 > -1f));
let _e5333 = select(1e6f, _e5331, (_e5331 < 1e6f));
let _e5340 = select(0i, select(select(i32(_e5333), i32(-2147483648), (_e5333 < -2147483600f)), 2147483647i, (_e5333 > 2147483500f)), (_e5333 == _e5333));
let _e5344 = (_e5340 - select(0i, 1i, (_e5333 < f32(_e5340))));
let _e5346 = (_e5312 - f32(_e5329));
let _e5348 = (_e5314 - f32(_e5344));
let _e5349 = (1f - _e5346);
let _e5350 = (1f - _e5348);
let _e5353 = select(_e5329, 0i, (_e5329 < 0i));
let _e5354 = (_e5353 >= _e5304.member);
if _e5354 {
phi_80910_ = (_e5304.member - 1i);
} else {
phi_80910_ = _e5353;
}
let _e5357 = phi_80910_;
let _e5359 = select(_e5344, 0i, (_e5344 < 0i));
let _e5360 = (_e5359 >= _e5304.member_1);
if _e5360 {
phi_80921_ = (_e5304.member_1 - 1i);
} else {
phi_80921_ = _e5359;
}
let _e5363 = phi_80921_;
let _e5367 = (((f32(_e5357) + 0.5f) * _e5309) - 0.5f);
let _e5371 = (((f32(_e5363) + 0.5f) * _e5309) - 0.5f);
if _e471 {
phi_80949_ = type_26(_e5363, _e5357);
} else {
phi_80949_ = type_26(_e5357, _e5363);
}
let _e5377 = phi_80949_;
let _e5383 = bitcast<i32>(((_e946 + 1u) >> bitcast<u32>(1u)));
let _e5386 = global_1.member.member_18.member_6;
let _e5389 = global_1.member.member_18.member_7;
let _e5392 = global_1.member.member_18.member_8;
let _e5393 = (_e5287 == 0u);
if _e5393 {
phi_81000_ = 0u;
} else {
if (_e5287 == 1u) {
phi_80999_ = 0u;
} else {
if (_e5287 == 2u) {
phi_80998_ = _e5386;
} else {
phi_80998_ = select(_e5392, _e5389, (_e5287 == 3u));
}
let _e5399 = phi_80998_;
phi_80999_ = _e5399;
}
let _e5401 = phi_80999_;
phi_81000_ = _e5401;
}
let _e5403 = phi_81000_;
local_32 = (((bitcast<i32>(_e5403) + _e5377.member_1) * _e5383) + _e5377.member);
let _e5408 = local_32;
let _e5410 = (bitcast<i32>(_e280) - 1i);
let _e5412 = select(_e5410, _e5408, (_e5408 < _e5410));
let _e5417 = global_6.member[bitcast<u32>(select(0i, _e5412, (_e5412 > 0i)))];
let _e5422 = (((((select(_e5367, _e5371, _e471) + 0.5f) / _e4912) * 2f) - 1f) * _e4920);
let _e5427 = ((1f - (((select(_e5371, _e5367, _e471) + 0.5f) / _e4913) * 2f)) * _e4928);
let _e5434 = ((_e4931.member * _e5422) + (_e4939.member * _e5427));
let _e5435 = ((_e4931.member_1 * _e5422) + (_e4939.member_1 * _e5427));
let _e5436 = ((_e4931.member_2 * _e5422) + (_e4939.member_2 * _e5427));
let _e5440 = select((_e4954.member + _e5434), _e4954.member, _e4952);
let _e5441 = select((_e4954.member_1 + _e5435), _e4954.member_1, _e4952);
let _e5442 = select((_e4954.member_2 + _e5436), _e4954.member_2, _e4952);
let _e5453 = (((_e5440 * _e5440) + (_e5441 * _e5441)) + (_e5442 * _e5442));
let _e5457 = (1f / sqrt(select(0f, _e5453, (_e5453 > 0f))));
let _e5458 = (_e5440 * _e5457);
let _e5459 = (_e5441 * _e5457);
let _e5460 = (_e5442 * _e5457);
let _e5461 = (_e593 - select(_e4965.member, (_e4965.member + _e5434), _e4952));
let _e5462 = (_e605 - select(_e4965.member_1, (_e4965.member_1 + _e5435), _e4952));
let _e5463 = (_e618 - select(_e4965.member_2, (_e4965.member_2 + _e5436), _e4952));
let _e5468 = (((_e5461 * _e5458) + (_e5462 * _e5459)) + (_e5463 * _e5460));
let _e5473 = (((_e5461 * _e631) + (_e5462 * _e644)) + (_e5463 * _e657));
let _e5478 = (((_e5458 * _e631) + (_e5459 * _e644)) + (_e5460 * _e657));
let _e5481 = ((_e5459 * _e657) - (_e5460 * _e644));
let _e5484 = ((_e5460 * _e631) - (_e5458 * _e657));
let _e5487 = ((_e5458 * _e644) - (_e5459 * _e631));
let _e5492 = (((_e5481 * _e5481) + (_e5484 * _e5484)) + (_e5487 * _e5487));
let _e5495 = (1f / select(1e-9f, _e5492, (_e5492 > 1e-9f)));
let _e5498 = ((_e5468 - (_e5478 * _e5473)) * _e5495);
let _e5501 = (((_e5478 * _e5468) - _e5473) * _e5495);
let _e5507 = select(0f, _e5498, (((_e5501 >= 0f) && (_e5501 < _e709)) && (_e5498 > 0f)));
let _e5509 = (_e5357 << bitcast<u32>(_e5288));
let _e5521 = (_e5329 + 1i);
let _e5524 = select(_e5521, 0i, (_e5521 < 0i));
let _e5525 = (_e5524 >= _e5304.member);
if _e5525 {
phi_81984_ = (_e5304.member - 1i);
} else {
phi_81984_ = _e5524;
}
let _e5528 = phi_81984_;
if _e5360 {
phi_81995_ = (_e5304.member_1 - 1i);
} else {
phi_81995_ = _e5359;
}
let _e5531 = phi_81995_;
let _e5535 = (((f32(_e5528) + 0.5f) * _e5309) - 0.5f);
let _e5539 = (((f32(_e5531) + 0.5f) * _e5309) - 0.5f);
if _e471 {
phi_82023_ = type_26(_e5531, _e5528);
} else {
phi_82023_ = type_26(_e5528, _e5531);
}
let _e5545 = phi_82023_;
if _e5393 {
phi_82074_ = 0u;
} else {
if (_e5287 == 1u) {
phi_82073_ = 0u;
} else {
if (_e5287 == 2u) {
phi_82072_ = _e5386;
} else {
phi_82072_ = select(_e5392, _e5389, (_e5287 == 3u));
}
let _e5553 = phi_82072_;
phi_82073_ = _e5553;
}
let _e5555 = phi_82073_;
phi_82074_ = _e5555;
}
let _e5557 = phi_82074_;
local_30 = (((bitcast<i32>(_e5557) + _e5545.member_1) * _e5383) + _e5545.member);
let _e5562 = local_30;
let _e5564 = select(_e5410, _e5562, (_e5562 < _e5410));
let _e5569 = global_6.member[bitcast<u32>(select(0i, _e5564, (_e5564 > 0i)))];
let _e5574 = (((((select(_e5535, _e5539, _e471) + 0.5f) / _e4912) * 2f) - 1f) * _e4920);
let _e5579 = ((1f - (((select(_e5539, _e5535, _e471) + 0.5f) / _e4913) * 2f)) * _e4928);
let _e5586 = ((_e4931.member * _e5574) + (_e4939.member * _e5579));
let _e5587 = ((_e4931.member_1 * _e5574) + (_e4939.member_1 * _e5579));
let _e5588 = ((_e4931.member_2 * _e5574) + (_e4939.member_2 * _e5579));
let _e5592 = select((_e4954.member + _e5586), _e4954.member, _e4952);
let _e5593 = select((_e4954.member_1 + _e5587), _e4954.member_1, _e4952);
let _e5594 = select((_e4954.member_2 + _e5588), _e4954.member_2, _e4952);
let _e5605 = (((_e5592 * _e5592) + (_e5593 * _e5593)) + (_e5594 * _e5594));
let _e5609 = (1f / sqrt(select(0f, _e5605, (_e5605 > 0f))));
let _e5610 = (_e5592 * _e5609);
let _e5611 = (_e5593 * _e5609);
let _e5612 = (_e5594 * _e5609);
let _e5613 = (_e593 - select(_e4965.member, (_e4965.member + _e5586), _e4952));
let _e5614 = (_e605 - select(_e4965.member_1, (_e4965.member_1 + _e5587), _e4952));
let _e5615 = (_e618 - select(_e4965.member_2, (_e4965.member_2 + _e5588), _e4952));
let _e5620 = (((_e5613 * _e5610) + (_e5614 * _e5611)) + (_e5615 * _e5612));
let _e5625 = (((_e5613 * _e631) + (_e5614 * _e644)) + (_e5615 * _e657));
let _e5630 = (((_e5610 * _e631) + (_e5611 * _e644)) + (_e5612 * _e657));
let _e5633 = ((_e5611 * _e657) - (_e5612 * _e644));
let _e5636 = ((_e5612 * _e631) - (_e5610 * _e657));
let _e5639 = ((_e5610 * _e644) - (_e5611 * _e631));
let _e5644 = (((_e5633 * _e5633) + (_e5636 * _e5636)) + (_e5639 * _e5639));
let _e5647 = (1f / select(1e-9f, _e5644, (_e5644 > 1e-9f)));
let _e5650 = ((_e5620 - (_e5630 * _e5625)) * _e5647);
let _e5653 = (((_e5630 * _e5620) - _e5625) * _e5647);
let _e5659 = select(0f, _e5650, (((_e5653 >= 0f) && (_e5653 < _e709)) && (_e5650 > 0f)));
let _e5661 = (_e5528 << bitcast<u32>(_e5288));
let _e5673 = (_e5344 + 1i);
if _e5354 {
phi_83058_ = (_e5304.member - 1i);
} else {
phi_83058_ = _e5353;
}
let _e5677 = phi_83058_;
let _e5679 = select(_e5673, 0i, (_e5673 < 0i));
let _e5680 = (_e5679 >= _e5304.member_1);
if _e5680 {
phi_83069_ = (_e5304.member_1 - 1i);
} else {
phi_83069_ = _e5679;
}
let _e5683 = phi_83069_;
let _e5687 = (((f32(_e5677) + 0.5f) * _e5309) - 0.5f);
let _e5691 = (((f32(_e5683) + 0.5f) * _e5309) - 0.5f);
if _e471 {
phi_83097_ = type_26(_e5683, _e5677);
} else {
phi_83097_ = type_26(_e5677, _e5683);
}
let _e5697 = phi_83097_;
if _e5393 {
phi_83148_ = 0u;
} else {
if (_e5287 == 1u) {
phi_83147_ = 0u;
} else {
if (_e5287 == 2u) {
phi_83146_ = _e5386;
} else {
phi_83146_ = select(_e5392, _e5389, (_e5287 == 3u));
}
let _e5705 = phi_83146_;
phi_83147_ = _e5705;
}
let _e5707 = phi_83147_;
phi_83148_ = _e5707;
}
let _e5709 = phi_83148_;
local_28 = (((bitcast<i32>(_e5709) + _e5697.member_1) * _e5383) + _e5697.member);
let _e5714 = local_28;
let _e5716 = select(_e5410, _e5714, (_e5714 < _e5410));
let _e5721 = global_6.member[bitcast<u32>(select(0i, _e5716, (_e5716 > 0i)))];
let _e5726 = (((((select(_e5687, _e5691, _e471) + 0.5f) / _e4912) * 2f) - 1f) * _e4920);
let _e5731 = ((1f - (((select(_e5691, _e5687, _e471) + 0.5f) / _e4913) * 2f)) * _e4928);
let _e5738 = ((_e4931.member * _e5726) + (_e4939.member * _e5731));
let _e5739 = ((_e4931.member_1 * _e5726) + (_e4939.member_1 * _e5731));
let _e5740 = ((_e4931.member_2 * _e5726) + (_e4939.member_2 * _e5731));
let _e5744 = select((_e4954.member + _e5738), _e4954.member, _e4952);
let _e5745 = select((_e4954.member_1 + _e5739), _e4954.member_1, _e4952);
let _e5746 = select((_e4954.member_2 + _e5740), _e4954.member_2, _e4952);
let _e5757 = (((_e5744 * _e5744) + (_e5745 * _e5745)) + (_e5746 * _e5746));
let _e5761 = (1f / sqrt(select(0f, _e5757, (_e5757 > 0f))));
let _e5762 = (_e5744 * _e5761);
let _e5763 = (_e5745 * _e5761);
let _e5764 = (_e5746 * _e5761);
let _e5765 = (_e593 - select(_e4965.member, (_e4965.member + _e5738), _e4952));
let _e5766 = (_e605 - select(_e4965.member_1, (_e4965.member_1 + _e5739), _e4952));
let _e5767 = (_e618 - select(_e4965.member_2, (_e4965.member_2 + _e5740), _e4952));
let _e5772 = (((_e5765 * _e5762) + (_e5766 * _e5763)) + (_e5767 * _e5764));
let _e5777 = (((_e5765 * _e631) + (_e5766 * _e644)) + (_e5767 * _e657));
let _e5782 = (((_e5762 * _e631) + (_e5763 * _e644)) + (_e5764 * _e657));
let _e5785 = ((_e5763 * _e657) - (_e5764 * _e644));
let _e5788 = ((_e5764 * _e631) - (_e5762 * _e657));
let _e5791 = ((_e5762 * _e644) - (_e5763 * _e631));
let _e5796 = (((_e5785 * _e5785) + (_e5788 * _e5788)) + (_e5791 * _e5791));
let _e5799 = (1f / select(1e-9f, _e5796, (_e5796 > 1e-9f)));
let _e5802 = ((_e5772 - (_e5782 * _e5777)) * _e5799);
let _e5805 = (((_e5782 * _e5772) - _e5777) * _e5799);
let _e5811 = select(0f, _e5802, (((_e5805 >= 0f) && (_e5805 < _e709)) && (_e5802 > 0f)));
let _e5813 = (_e5677 << bitcast<u32>(_e5288));
if _e5525 {
phi_84132_ = (_e5304.member - 1i);
} else {
phi_84132_ = _e5524;
}
let _e5828 = phi_84132_;
if _e5680 {
phi_84143_ = (_e5304.member_1 - 1i);
} else {
phi_84143_ = _e5679;
}
let _e5831 = phi_84143_;
let _e5835 = (((f32(_e5828) + 0.5f) * _e5309) - 0.5f);
let _e5839 = (((f32(_e5831) + 0.5f) * _e5309) - 0.5f);
if _e471 {
phi_84171_ = type_26(_e5831, _e5828);
} else {
phi_84171_ = type_26(_e5828, _e5831);
}
let _e5845 = phi_84171_;
if _e5393 {
phi_84222_ = 0u;
} else {
if (_e5287 == 1u) {
phi_84221_ = 0u;
} else {
if (_e5287 == 2u) {
phi_84220_ = _e5386;
} else {
phi_84220_ = select(_e5392, _e5389, (_e5287 == 3u));
}
let _e5853 = phi_84220_;
phi_84221_ = _e5853;
}
let _e5855 = phi_84221_;
phi_84222_ = _e5855;
}
let _e5857 = phi_84222_;
local_26 = (((bitcast<i32>(_e5857) + _e5845.member_1) * _e5383) + _e5845.member);
let _e5862 = local_26;
let _e5864 = select(_e5410, _e5862, (_e5862 < _e5410));
let _e5869 = global_6.member[bitcast<u32>(select(0i, _e5864, (_e5864 > 0i)))];
let _e5874 = (((((select(_e5835, _e5839, _e471) + 0.5f) / _e4912) * 2f) - 1f) * _e4920);
let _e5879 = ((1f - (((select(_e5839, _e5835, _e471) + 0.5f) / _e4913) * 2f)) * _e4928);
let _e5886 = ((_e4931.member * _e5874) + (_e4939.member * _e5879));
let _e5887 = ((_e4931.member_1 * _e5874) + (_e4939.member_1 * _e5879));
let _e5888 = ((_e4931.member_2 * _e5874) + (_e4939.member_2 * _e5879));
let _e5892 = select((_e4954.member + _e5886), _e4954.member, _e4952);
let _e5893 = select((_e4954.member_1 + _e5887), _e4954.member_1, _e4952);
let _e5894 = select((_e4954.member_2 + _e5888), _e4954.member_2, _e4952);
let _e5905 = (((_e5892 * _e5892) + (_e5893 * _e5893)) + (_e5894 * _e5894));
let _e5909 = (1f / sqrt(select(0f, _e5905, (_e5905 > 0f))));
let _e5910 = (_e5892 * _e5909);
let _e5911 = (_e5893 * _e5909);
let _e5912 = (_e5894 * _e5909);
let _e5913 = (_e593 - select(_e4965.member, (_e4965.member + _e5886), _e4952));
let _e5914 = (_e605 - select(_e4965.member_1, (_e4965.member_1 + _e5887), _e4952));
let _e5915 = (_e618 - select(_e4965.member_2, (_e4965.member_2 + _e5888), _e4952));
let _e5920 = (((_e5913 * _e5910) + (_e5914 * _e5911)) + (_e5915 * _e5912));
let _e5925 = (((_e5913 * _e631) + (_e5914 * _e644)) + (_e5915 * _e657));
let _e5930 = (((_e5910 * _e631) + (_e5911 * _e644)) + (_e5912 * _e657));
let _e5933 = ((_e5911 * _e657) - (_e5912 * _e644));
let _e5936 = ((_e5912 * _e631) - (_e5910 * _e657));
let _e5939 = ((_e5910 * _e644) - (_e5911 * _e631));
let _e5944 = (((_e5933 * _e5933) + (_e5936 * _e5936)) + (_e5939 * _e5939));
let _e5947 = (1f / select(1e-9f, _e5944, (_e5944 > 1e-9f)));
let _e5950 = ((_e5920 - (_e5930 * _e5925)) * _e5947);
let _e5953 = (((_e5930 * _e5920) - _e5925) * _e5947);
let _e5959 = select(0f, _e5950, (((_e5953 >= 0f) && (_e5953 < _e709)) && (_e5950 > 0f)));
let _e5961 = (_e5828 << bitcast<u32>(_e5288));
let _e5973 = select(((((1f - select(0f, (_e5349 * _e5350), (((select(select(_e784, _e941, (_e5509 >= _e710)), _e863, (_e5509 < _e316)) == _e5287) && (_e5507 > 0f)) && (_e5507 < _e5417)))) - select(0f, (_e5346 * _e5350), (((select(select(_e784, _e941, (_e5661 >= _e710)), _e863, (_e5661 < _e316)) == _e5287) && (_e5659 > 0f)) && (_e5659 < _e5569)))) - select(0f, (_e5349 * _e5348), (((select(select(_e784, _e941, (_e5813 >= _e710)), _e863, (_e5813 < _e316)) == _e5287) && (_e5811 > 0f)) && (_e5811 < _e5721)))) - select(0f, (_e5346 * _e5348), (((select(select(_e784, _e941, (_e5961 >= _e710)), _e863, (_e5961 < _e316)) == _e5287) && (_e5959 > 0f)) && (_e5959 < _e5869)))), 1f, _e5393);
if _e471 {
phi_85215_ = type_26(_e4829, _e4736);
} else {
phi_85215_ = type_26(_e4736, _e4829);
}
let _e5988 = phi_85215_;
let _e5991 = (_e4830 && (((_e5285 > 0f) && (_e5285 < _e4909)) && (bitcast<f32>((bitcast<u32>(_e5973) & 2147483647u)) > 1e-6f)));
let _e5994 = global_1.member.member_18.member;
let _e5995 = (((select(_e4855, (1f - _e4855), (_e4840 >= 0f)) - select(_e4874, (1f - _e4874), (_e4859 >= 0f))) * (1f / _e4837)) * _e5994);
let _e5999 = select(0f, (((((_e670 * _e5272.member) * ((1f + (_e5153 * (1f + (_e5153 * (0.5f + (_e5153 * (0.16666667f + (_e5153 * (0.041666668f + (_e5153 * (0.008333334f + (_e5153 * (0.001388889f + (_e5153 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5148 + 127i)) << bitcast<u32>(23i))))) * _e5115) * _e5973) * _e5995), _e5991);
let _e6000 = select(0f, (((((_e683 * _e5272.member_1) * ((1f + (_e5201 * (1f + (_e5201 * (0.5f + (_e5201 * (0.16666667f + (_e5201 * (0.041666668f + (_e5201 * (0.008333334f + (_e5201 * (0.001388889f + (_e5201 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5196 + 127i)) << bitcast<u32>(23i))))) * _e5115) * _e5973) * _e5995), _e5991);
let _e6001 = select(0f, (((((_e696 * _e5272.member_2) * ((1f + (_e5249 * (1f + (_e5249 * (0.5f + (_e5249 * (0.16666667f + (_e5249 * (0.041666668f + (_e5249 * (0.008333334f + (_e5249 * (0.001388889f + (_e5249 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5244 + 127i)) << bitcast<u32>(23i))))) * _e5115) * _e5973) * _e5995), _e5991);
let _e6005 = (bitcast<f32>((bitcast<u32>(_e5999) & 2147483647u)) >= 1073741800f);
let _e6006 = (1f / 1048576f);
let _e6009 = ((_e5999 * select(1f, _e6006, _e6005)) + 0.5f);
let _e6011 = select(-1073741800f, _e6009, (_e6009 > -1073741800f));
let _e6013 = select(1073741800f, _e6011, (_e6011 < 1073741800f));
let _e6020 = select(0i, select(select(i32(_e6013), i32(-2147483648), (_e6013 < -2147483600f)), 2147483647i, (_e6013 > 2147483500f)), (_e6013 == _e6013));
let _e6024 = (_e6020 - select(0i, 1i, (_e6013 < f32(_e6020))));
let _e6025 = select(0i, 20i, _e6005);
let _e6029 = (bitcast<u32>(_e6024) << bitcast<u32>((_e6025 & 31i)));
let _e6036 = bitcast<u32>(((_e6024 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6025) & 31i))));
let _e6040 = (bitcast<f32>((bitcast<u32>(_e6000) & 2147483647u)) >= 1073741800f);
let _e6043 = ((_e6000 * select(1f, _e6006, _e6040)) + 0.5f);
let _e6045 = select(-1073741800f, _e6043, (_e6043 > -1073741800f));
let _e6047 = select(1073741800f, _e6045, (_e6045 < 1073741800f));
let _e6054 = select(0i, select(select(i32(_e6047), i32(-2147483648), (_e6047 < -2147483600f)), 2147483647i, (_e6047 > 2147483500f)), (_e6047 == _e6047));
let _e6058 = (_e6054 - select(0i, 1i, (_e6047 < f32(_e6054))));
let _e6059 = select(0i, 20i, _e6040);
let _e6063 = (bitcast<u32>(_e6058) << bitcast<u32>((_e6059 & 31i)));
let _e6070 = bitcast<u32>(((_e6058 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6059) & 31i))));
let _e6074 = (bitcast<f32>((bitcast<u32>(_e6001) & 2147483647u)) >= 1073741800f);
let _e6077 = ((_e6001 * select(1f, _e6006, _e6074)) + 0.5f);
let _e6079 = select(-1073741800f, _e6077, (_e6077 > -1073741800f));
let _e6081 = select(1073741800f, _e6079, (_e6079 < 1073741800f));
let _e6088 = select(0i, select(select(i32(_e6081), i32(-2147483648), (_e6081 < -2147483600f)), 2147483647i, (_e6081 > 2147483500f)), (_e6081 == _e6081));
let _e6092 = (_e6088 - select(0i, 1i, (_e6081 < f32(_e6088))));
let _e6093 = select(0i, 20i, _e6074);
let _e6097 = (bitcast<u32>(_e6092) << bitcast<u32>((_e6093 & 31i)));
let _e6104 = bitcast<u32>(((_e6092 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6093) & 31i))));
let _e6109 = bitcast<i32>(bitcast<u32>((((_e5988.member_1 * _e950) + _e5988.member) * 6i)));
if ((_e6029 | _e6036) == 0u) {
} else {
let _e6112 = bitcast<u32>(_e6109);
if (_e6112 < _e288) {
let _e6116 = atomicAdd((&global_8.member[_e6112]), _e6029);
phi_85448_ = _e6116;
} else {
phi_85448_ = 0u;
}
let _e6118 = phi_85448_;
let _e6122 = (_e6036 + select(0u, 1u, ((_e6118 + _e6029) < _e6029)));
if (_e6122 == 0u) {
} else {
let _e6124 = (_e6112 + 1u);
if (_e6124 < _e288) {
let _e6128 = atomicAdd((&global_8.member[_e6124]), _e6122);
}
}
}
if ((_e6063 | _e6070) == 0u) {
} else {
let _e6132 = bitcast<u32>((_e6109 + 2i));
if (_e6132 < _e288) {
let _e6136 = atomicAdd((&global_8.member[_e6132]), _e6063);
phi_85478_ = _e6136;
} else {
phi_85478_ = 0u;
}
let _e6138 = phi_85478_;
let _e6142 = (_e6070 + select(0u, 1u, ((_e6138 + _e6063) < _e6063)));
if (_e6142 == 0u) {
} else {
let _e6144 = (_e6132 + 1u);
if (_e6144 < _e288) {
let _e6148 = atomicAdd((&global_8.member[_e6144]), _e6142);
}
}
}
if ((_e6097 | _e6104) == 0u) {
} else {
let _e6152 = bitcast<u32>((_e6109 + 4i));
if (_e6152 < _e288) {
let _e6156 = atomicAdd((&global_8.member[_e6152]), _e6097);
phi_85508_ = _e6156;
} else {
phi_85508_ = 0u;
}
let _e6158 = phi_85508_;
let _e6162 = (_e6104 + select(0u, 1u, ((_e6158 + _e6097) < _e6097)));
if (_e6162 == 0u) {
} else {
let _e6164 = (_e6152 + 1u);
if (_e6164 < _e288) {
let _e6168 = atomicAdd((&global_8.member[_e6164]), _e6162);
}
}
}
phi_79673_ = (_e4827 + 1i);
} else {
phi_79673_ = i32();
}
let _e6171 = phi_79673_;
continue;
continuing {
phi_79672_ = _e6171;
break if !(_e4830);
}
}
phi_79519_ = (_e4733 + 1i);
} else {
phi_79519_ = i32();
}
let _e6175 = phi_79519_;
continue;
continuing {
phi_79518_ = _e6175;
break if !(_e4734);
}
}
} else {
phi_85553_ = 0i;
loop {
let _e1962 = phi_85553_;
let _e1963 = (_e1962 < 16i);
if _e1963 {
let _e1965 = (_e995 + (_e1962 & 15i));
let _e1967 = (f32(_e1965) + 0.5f);
let _e1969 = ((_e1967 * 1f) - 0.5f);
let _e1973 = (-(((_e434 * _e1969) + _e460)) / _e447);
let _e1980 = bitcast<f32>((bitcast<u32>(((_e484 * _e1969) + ((_e497 * _e1973) + _e510))) & 2147483647u));
let _e1987 = bitcast<f32>((bitcast<u32>(((_e523 * _e1969) + ((_e536 * _e1973) + _e549))) & 2147483647u));
let _e1991 = (((0.5f * (_e1980 + _e1987)) / _e552) + _e735);
let _e1992 = (1f / 1f);
let _e2000 = ((((_e1973 + _e1991) + 0.5f) * _e1992) - 0.5f);
let _e2001 = f32(_e1944);
let _e2002 = f32(_e1942);
let _e2003 = (_e2001 - 1f);
let _e2005 = select(_e2003, _e2000, (_e2000 > _e2003));
let _e2007 = select(_e2002, _e2005, (_e2005 < _e2002));
let _e2014 = select(0i, select(select(i32(_e2007), i32(-2147483648), (_e2007 < -2147483600f)), 2147483647i, (_e2007 > 2147483500f)), (_e2007 == _e2007));
let _e2019 = (((((_e1973 - _e1991) + 0.5f) * _e1992) - 0.5f) + 1f);
let _e2020 = (_e2002 + 1f);
let _e2022 = select(_e2001, _e2019, (_e2019 > _e2001));
let _e2024 = select(_e2020, _e2022, (_e2022 < _e2020));
let _e2031 = select(0i, select(select(i32(_e2024), i32(-2147483648), (_e2024 < -2147483600f)), 2147483647i, (_e2024 > 2147483500f)), (_e2024 == _e2024));
let _e2042 = ((1e-4f * 1f) * _e552);
let _e2044 = select(_e1987, _e1980, (_e1980 > _e1987));
let _e2046 = select(_e2042, _e2044, (_e2044 > _e2042));
let _e2048 = select(_e1987, _e1980, (_e1980 < _e1987));
let _e2050 = select(_e2042, _e2048, (_e2048 > _e2042));
let _e2052 = (0.5f * (_e2046 + _e2050));
let _e2053 = (0.5f / _e2050);
let _e2054 = (1f / _e2046);
phi_85707_ = 0i;
loop {
let _e2056 = phi_85707_;
let _e2058 = (((_e2031 - select(0i, 1i, (_e2024 < f32(_e2031)))) + (_e1962 >> bitcast<u32>(4u))) + bitcast<i32>(_e2056));
let _e2059 = (_e2058 <= select(-1i, (_e2014 - select(0i, 1i, (_e2007 < f32(_e2014)))), (_e1965 <= _e999)));
if _e2059 {
let _e2061 = (f32(_e2058) + 0.5f);
let _e2065 = ((((_e2061 * 1f) - 0.5f) - _e1973) * _e552);
let _e2066 = (_e552 * 1f);
let _e2068 = (0.5f * _e2066);
let _e2069 = (_e2065 + _e2068);
let _e2070 = -(_e2069);
let _e2073 = (_e2052 - select(_e2070, _e2069, (_e2069 > _e2070)));
let _e2075 = select(0f, _e2073, (_e2073 > 0f));
let _e2077 = select(_e2050, _e2075, (_e2075 < _e2050));
let _e2080 = (_e2073 - _e2050);
let _e2084 = (((_e2077 * (_e2077 * _e2053)) + select(0f, _e2080, (_e2080 > 0f))) * _e2054);
let _e2088 = (_e2065 - _e2068);
let _e2089 = -(_e2088);
let _e2092 = (_e2052 - select(_e2089, _e2088, (_e2088 > _e2089)));
let _e2094 = select(0f, _e2092, (_e2092 > 0f));
let _e2096 = select(_e2050, _e2094, (_e2094 < _e2050));
let _e2099 = (_e2092 - _e2050);
let _e2103 = (((_e2096 * (_e2096 * _e2053)) + select(0f, _e2099, (_e2099 > 0f))) * _e2054);
if _e471 {
phi_85812_ = type_26(_e2058, _e1965);
} else {
phi_85812_ = type_26(_e1965, _e2058);
}
let _e2112 = phi_85812_;
local_24 = bitcast<i32>((_e946 * _e949));
local_25 = ((_e2112.member_1 * _e950) + _e2112.member);
let _e2119 = local_24;
let _e2120 = local_25;
let _e2121 = (_e2119 + _e2120);
let _e2123 = (bitcast<i32>(_e277) - 1i);
let _e2125 = select(_e2123, _e2121, (_e2121 < _e2123));
let _e2130 = global_5.member[bitcast<u32>(select(0i, _e2125, (_e2125 > 0i)))];
let _e2131 = local_25;
let _e2133 = select(_e2123, _e2131, (_e2131 < _e2123));
let _e2138 = global_5.member[bitcast<u32>(select(0i, _e2133, (_e2133 > 0i)))];
let _e2141 = f32(_e950);
let _e2142 = f32(_e951);
let _e2149 = global_1.member.member_2.member;
let _e2150 = (((((f32(_e2112.member) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e2157 = global_1.member.member_2.member_1;
let _e2158 = ((1f - (((f32(_e2112.member_1) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e2160 = global_1.member.member_3;
let _e2168 = global_1.member.member_4;
let _e2175 = ((_e2160.member * _e2150) + (_e2168.member * _e2158));
let _e2176 = ((_e2160.member_1 * _e2150) + (_e2168.member_1 * _e2158));
let _e2177 = ((_e2160.member_2 * _e2150) + (_e2168.member_2 * _e2158));
let _e2180 = global_1.member.member_2.member_3;
let _e2181 = (_e2180 != 0u);
let _e2183 = global_1.member.member_5;
let _e2190 = select((_e2183.member + _e2175), _e2183.member, _e2181);
let _e2191 = select((_e2183.member_1 + _e2176), _e2183.member_1, _e2181);
let _e2192 = select((_e2183.member_2 + _e2177), _e2183.member_2, _e2181);
let _e2194 = global_1.member.member_6;
let _e2208 = (((_e2190 * _e2190) + (_e2191 * _e2191)) + (_e2192 * _e2192));
let _e2211 = sqrt(select(0f, _e2208, (_e2208 > 0f)));
let _e2212 = (1f / _e2211);
let _e2213 = (_e2190 * _e2212);
let _e2214 = (_e2191 * _e2212);
let _e2215 = (_e2192 * _e2212);
let _e2216 = (_e593 - select(_e2194.member, (_e2194.member + _e2175), _e2181));
let _e2217 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e2176), _e2181));
let _e2218 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e2177), _e2181));
let _e2223 = (((_e2216 * _e2213) + (_e2217 * _e2214)) + (_e2218 * _e2215));
let _e2228 = (((_e2216 * _e631) + (_e2217 * _e644)) + (_e2218 * _e657));
let _e2233 = (((_e2213 * _e631) + (_e2214 * _e644)) + (_e2215 * _e657));
let _e2236 = ((_e2214 * _e657) - (_e2215 * _e644));
let _e2239 = ((_e2215 * _e631) - (_e2213 * _e657));
let _e2242 = ((_e2213 * _e644) - (_e2214 * _e631));
let _e2247 = (((_e2236 * _e2236) + (_e2239 * _e2239)) + (_e2242 * _e2242));
let _e2250 = (1f / select(1e-9f, _e2247, (_e2247 > 1e-9f)));
let _e2253 = ((_e2223 - (_e2233 * _e2228)) * _e2250);
let _e2256 = (((_e2233 * _e2223) - _e2228) * _e2250);
let _e2262 = -(_e2233);
let _e2265 = global_1.member.member_13.member_2;
let _e2266 = (_e2265 * _e2265);
let _e2270 = ((1f + _e2266) - ((2f * _e2265) * _e2262));
let _e2272 = select(1e-9f, _e2270, (_e2270 > 1e-9f));
let _e2284 = global_1.member.member_13.member_3;
if (_e2284 == 2u) {
let _e2289 = (0.5f - (0.5f * _e2262));
let _e2291 = select(0f, _e2289, (_e2289 > 0f));
let _e2295 = (sqrt(select(0f, _e2291, (_e2291 > 0f))) * 255f);
let _e2296 = (255f - 1f);
let _e2298 = select(0f, _e2295, (_e2295 > 0f));
let _e2300 = select(_e2296, _e2298, (_e2298 < _e2296));
let _e2307 = select(0i, select(select(i32(_e2300), i32(-2147483648), (_e2300 < -2147483600f)), 2147483647i, (_e2300 > 2147483500f)), (_e2300 == _e2300));
let _e2311 = (_e2307 - select(0i, 1i, (_e2300 < f32(_e2307))));
let _e2314 = global_1.member.member_13.member_11;
let _e2315 = bitcast<i32>(_e2314);
let _e2316 = (_e2315 + _e2311);
let _e2318 = (bitcast<i32>(_e283) - 1i);
let _e2320 = select(_e2318, _e2316, (_e2316 < _e2318));
let _e2325 = global_2.member[bitcast<u32>(select(0i, _e2320, (_e2320 > 0i)))];
let _e2327 = (_e2315 + (_e2311 + 1i));
let _e2329 = select(_e2318, _e2327, (_e2327 < _e2318));
let _e2334 = global_2.member[bitcast<u32>(select(0i, _e2329, (_e2329 > 0i)))];
phi_86239_ = (_e2325 + ((_e2334 - _e2325) * (_e2295 - f32(_e2311))));
} else {
phi_86239_ = select(((1f - _e2266) / (_e2272 * sqrt(select(0f, _e2272, (_e2272 > 0f))))), (0.75f * (1f + (_e2262 * _e2262))), (_e2284 == 1u));
}
let _e2341 = phi_86239_;
let _e2344 = (_e2211 * (_e2341 * (0.25f / 3.1415927f)));
let _e2345 = (_e2253 - _e2130);
let _e2348 = (_e2256 + select(0f, _e2345, (_e2345 > 0f)));
let _e2351 = global_1.member.member_13.member;
let _e2356 = -((_e2351.member * _e2348));
let _e2358 = select(-87f, _e2356, (_e2356 > -87f));
let _e2360 = select(88f, _e2358, (_e2358 < 88f));
let _e2362 = ((_e2360 * 1.442695f) + 0.5f);
let _e2364 = select(-127f, _e2362, (_e2362 > -127f));
let _e2366 = select(128f, _e2364, (_e2364 < 128f));
let _e2373 = select(0i, select(select(i32(_e2366), i32(-2147483648), (_e2366 < -2147483600f)), 2147483647i, (_e2366 > 2147483500f)), (_e2366 == _e2366));
let _e2377 = (_e2373 - select(0i, 1i, (_e2366 < f32(_e2373))));
let _e2378 = f32(_e2377);
let _e2382 = ((_e2360 - (_e2378 * 0.6933594f)) - (_e2378 * -2.1219444e-4f));
let _e2404 = -((_e2351.member_1 * _e2348));
let _e2406 = select(-87f, _e2404, (_e2404 > -87f));
let _e2408 = select(88f, _e2406, (_e2406 < 88f));
let _e2410 = ((_e2408 * 1.442695f) + 0.5f);
let _e2412 = select(-127f, _e2410, (_e2410 > -127f));
let _e2414 = select(128f, _e2412, (_e2412 < 128f));
let _e2421 = select(0i, select(select(i32(_e2414), i32(-2147483648), (_e2414 < -2147483600f)), 2147483647i, (_e2414 > 2147483500f)), (_e2414 == _e2414));
let _e2425 = (_e2421 - select(0i, 1i, (_e2414 < f32(_e2421))));
let _e2426 = f32(_e2425);
let _e2430 = ((_e2408 - (_e2426 * 0.6933594f)) - (_e2426 * -2.1219444e-4f));
let _e2452 = -((_e2351.member_2 * _e2348));
let _e2454 = select(-87f, _e2452, (_e2452 > -87f));
let _e2456 = select(88f, _e2454, (_e2454 < 88f));
let _e2458 = ((_e2456 * 1.442695f) + 0.5f);
let _e2460 = select(-127f, _e2458, (_e2458 > -127f));
let _e2462 = select(128f, _e2460, (_e2460 < 128f));
let _e2469 = select(0i, select(select(i32(_e2462), i32(-2147483648), (_e2462 < -2147483600f)), 2147483647i, (_e2462 > 2147483500f)), (_e2462 == _e2462));
let _e2473 = (_e2469 - select(0i, 1i, (_e2462 < f32(_e2469))));
let _e2474 = f32(_e2473);
let _e2478 = ((_e2456 - (_e2474 * 0.6933594f)) - (_e2474 * -2.1219444e-4f));
let _e2501 = global_1.member.member_13.member_1;
let _e2514 = select(0f, _e2253, (((_e2256 >= 0f) && (_e2256 < _e709)) && (_e2253 > 0f)));
if _e471 {
phi_86865_ = type_26(_e1014, _e1013);
} else {
phi_86865_ = type_26(_e1013, _e1014);
}
let _e2518 = phi_86865_;
let _e2523 = f32((1i << bitcast<u32>(_e1002)));
let _e2524 = (1f / _e2523);
let _e2526 = ((_e1967 * _e2524) - 0.5f);
let _e2528 = ((_e2061 * _e2524) - 0.5f);
let _e2530 = select(-1f, _e2526, (_e2526 > -1f));
let _e2532 = select(1e6f, _e2530, (_e2530 < 1e6f));
let _e2539 = select(0i, select(select(i32(_e2532), i32(-2147483648), (_e2532 < -2147483600f)), 2147483647i, (_e2532 > 2147483500f)), (_e2532 == _e2532));
let _e2543 = (_e2539 - select(0i, 1i, (_e2532 < f32(_e2539))));
let _e2545 = select(-1f, _e2528, (_e2528 > -1f));
let _e2547 = select(1e6f, _e2545, (_e2545 < 1e6f));
let _e2554 = select(0i, select(select(i32(_e2547), i32(-2147483648), (_e2547 < -2147483600f)), 2147483647i, (_e2547 > 2147483500f)), (_e2547 == _e2547));
let _e2558 = (_e2554 - select(0i, 1i, (_e2547 < f32(_e2554))));
let _e2560 = (_e2526 - f32(_e2543));
let _e2562 = (_e2528 - f32(_e2558));
let _e2563 = (1f - _e2560);
let _e2564 = (1f - _e2562);
let _e2567 = select(_e2543, 0i, (_e2543 < 0i));
let _e2568 = (_e2567 >= _e2518.member);
if _e2568 {
phi_86943_ = (_e2518.member - 1i);
} else {
phi_86943_ = _e2567;
}
let _e2571 = phi_86943_;
let _e2573 = select(_e2558, 0i, (_e2558 < 0i));
let _e2574 = (_e2573 >= _e2518.member_1);
if _e2574 {
phi_86954_ = (_e2518.member_1 - 1i);
} else {
phi_86954_ = _e2573;
}
let _e2577 = phi_86954_;
let _e2581 = (((f32(_e2571) + 0.5f) * _e2523) - 0.5f);
let _e2585 = (((f32(_e2577) + 0.5f) * _e2523) - 0.5f);
if _e471 {
phi_86982_ = type_26(_e2577, _e2571);
} else {
phi_86982_ = type_26(_e2571, _e2577);
}
let _e2591 = phi_86982_;
let _e2597 = bitcast<i32>(((_e946 + 1u) >> bitcast<u32>(1u)));
let _e2600 = global_1.member.member_18.member_6;
let _e2603 = global_1.member.member_18.member_7;
let _e2606 = global_1.member.member_18.member_8;
if _e1001 {
phi_87033_ = 0u;
} else {
if (_e784 == 1u) {
phi_87032_ = 0u;
} else {
if (_e784 == 2u) {
phi_87031_ = _e2600;
} else {
phi_87031_ = select(_e2606, _e2603, (_e784 == 3u));
}
let _e2612 = phi_87031_;
phi_87032_ = _e2612;
}
let _e2614 = phi_87032_;
phi_87033_ = _e2614;
}
let _e2616 = phi_87033_;
local_22 = (((bitcast<i32>(_e2616) + _e2591.member_1) * _e2597) + _e2591.member);
let _e2621 = local_22;
let _e2623 = (bitcast<i32>(_e280) - 1i);
let _e2625 = select(_e2623, _e2621, (_e2621 < _e2623));
let _e2630 = global_6.member[bitcast<u32>(select(0i, _e2625, (_e2625 > 0i)))];
let _e2635 = (((((select(_e2581, _e2585, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e2640 = ((1f - (((select(_e2585, _e2581, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e2647 = ((_e2160.member * _e2635) + (_e2168.member * _e2640));
let _e2648 = ((_e2160.member_1 * _e2635) + (_e2168.member_1 * _e2640));
let _e2649 = ((_e2160.member_2 * _e2635) + (_e2168.member_2 * _e2640));
let _e2653 = select((_e2183.member + _e2647), _e2183.member, _e2181);
let _e2654 = select((_e2183.member_1 + _e2648), _e2183.member_1, _e2181);
let _e2655 = select((_e2183.member_2 + _e2649), _e2183.member_2, _e2181);
let _e2666 = (((_e2653 * _e2653) + (_e2654 * _e2654)) + (_e2655 * _e2655));
let _e2670 = (1f / sqrt(select(0f, _e2666, (_e2666 > 0f))));
let _e2671 = (_e2653 * _e2670);
let _e2672 = (_e2654 * _e2670);
let _e2673 = (_e2655 * _e2670);
let _e2674 = (_e593 - select(_e2194.member, (_e2194.member + _e2647), _e2181));
let _e2675 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e2648), _e2181));
let _e2676 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e2649), _e2181));
let _e2681 = (((_e2674 * _e2671) + (_e2675 * _e2672)) + (_e2676 * _e2673));
let _e2686 = (((_e2674 * _e631) + (_e2675 * _e644)) + (_e2676 * _e657));
let _e2691 = (((_e2671 * _e631) + (_e2672 * _e644)) + (_e2673 * _e657));
let _e2694 = ((_e2672 * _e657) - (_e2673 * _e644));
let _e2697 = ((_e2673 * _e631) - (_e2671 * _e657));
let _e2700 = ((_e2671 * _e644) - (_e2672 * _e631));
let _e2705 = (((_e2694 * _e2694) + (_e2697 * _e2697)) + (_e2700 * _e2700));
let _e2708 = (1f / select(1e-9f, _e2705, (_e2705 > 1e-9f)));
let _e2711 = ((_e2681 - (_e2691 * _e2686)) * _e2708);
let _e2714 = (((_e2691 * _e2681) - _e2686) * _e2708);
let _e2720 = select(0f, _e2711, (((_e2714 >= 0f) && (_e2714 < _e709)) && (_e2711 > 0f)));
let _e2722 = (_e2571 << bitcast<u32>(_e1002));
let _e2734 = (_e2543 + 1i);
let _e2737 = select(_e2734, 0i, (_e2734 < 0i));
let _e2738 = (_e2737 >= _e2518.member);
if _e2738 {
phi_88017_ = (_e2518.member - 1i);
} else {
phi_88017_ = _e2737;
}
let _e2741 = phi_88017_;
if _e2574 {
phi_88028_ = (_e2518.member_1 - 1i);
} else {
phi_88028_ = _e2573;
}
let _e2744 = phi_88028_;
let _e2748 = (((f32(_e2741) + 0.5f) * _e2523) - 0.5f);
let _e2752 = (((f32(_e2744) + 0.5f) * _e2523) - 0.5f);
if _e471 {
phi_88056_ = type_26(_e2744, _e2741);
} else {
phi_88056_ = type_26(_e2741, _e2744);
}
let _e2758 = phi_88056_;
if _e1001 {
phi_88107_ = 0u;
} else {
if (_e784 == 1u) {
phi_88106_ = 0u;
} else {
if (_e784 == 2u) {
phi_88105_ = _e2600;
} else {
phi_88105_ = select(_e2606, _e2603, (_e784 == 3u));
}
let _e2766 = phi_88105_;
phi_88106_ = _e2766;
}
let _e2768 = phi_88106_;
phi_88107_ = _e2768;
}
let _e2770 = phi_88107_;
local_20 = (((bitcast<i32>(_e2770) + _e2758.member_1) * _e2597) + _e2758.member);
let _e2775 = local_20;
let _e2777 = select(_e2623, _e2775, (_e2775 < _e2623));
let _e2782 = global_6.member[bitcast<u32>(select(0i, _e2777, (_e2777 > 0i)))];
let _e2787 = (((((select(_e2748, _e2752, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e2792 = ((1f - (((select(_e2752, _e2748, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e2799 = ((_e2160.member * _e2787) + (_e2168.member * _e2792));
let _e2800 = ((_e2160.member_1 * _e2787) + (_e2168.member_1 * _e2792));
let _e2801 = ((_e2160.member_2 * _e2787) + (_e2168.member_2 * _e2792));
let _e2805 = select((_e2183.member + _e2799), _e2183.member, _e2181);
let _e2806 = select((_e2183.member_1 + _e2800), _e2183.member_1, _e2181);
let _e2807 = select((_e2183.member_2 + _e2801), _e2183.member_2, _e2181);
let _e2818 = (((_e2805 * _e2805) + (_e2806 * _e2806)) + (_e2807 * _e2807));
let _e2822 = (1f / sqrt(select(0f, _e2818, (_e2818 > 0f))));
let _e2823 = (_e2805 * _e2822);
let _e2824 = (_e2806 * _e2822);
let _e2825 = (_e2807 * _e2822);
let _e2826 = (_e593 - select(_e2194.member, (_e2194.member + _e2799), _e2181));
let _e2827 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e2800), _e2181));
let _e2828 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e2801), _e2181));
let _e2833 = (((_e2826 * _e2823) + (_e2827 * _e2824)) + (_e2828 * _e2825));
let _e2838 = (((_e2826 * _e631) + (_e2827 * _e644)) + (_e2828 * _e657));
let _e2843 = (((_e2823 * _e631) + (_e2824 * _e644)) + (_e2825 * _e657));
let _e2846 = ((_e2824 * _e657) - (_e2825 * _e644));
let _e2849 = ((_e2825 * _e631) - (_e2823 * _e657));
let _e2852 = ((_e2823 * _e644) - (_e2824 * _e631));
let _e2857 = (((_e2846 * _e2846) + (_e2849 * _e2849)) + (_e2852 * _e2852));
let _e2860 = (1f / select(1e-9f, _e2857, (_e2857 > 1e-9f)));
let _e2863 = ((_e2833 - (_e2843 * _e2838)) * _e2860);
let _e2866 = (((_e2843 * _e2833) - _e2838) * _e2860);
let _e2872 = select(0f, _e2863, (((_e2866 >= 0f) && (_e2866 < _e709)) && (_e2863 > 0f)));
let _e2874 = (_e2741 << bitcast<u32>(_e1002));
let _e2886 = (_e2558 + 1i);
if _e2568 {
phi_89091_ = (_e2518.member - 1i);
} else {
phi_89091_ = _e2567;
}
let _e2890 = phi_89091_;
let _e2892 = select(_e2886, 0i, (_e2886 < 0i));
let _e2893 = (_e2892 >= _e2518.member_1);
if _e2893 {
phi_89102_ = (_e2518.member_1 - 1i);
} else {
phi_89102_ = _e2892;
}
let _e2896 = phi_89102_;
let _e2900 = (((f32(_e2890) + 0.5f) * _e2523) - 0.5f);
let _e2904 = (((f32(_e2896) + 0.5f) * _e2523) - 0.5f);
if _e471 {
phi_89130_ = type_26(_e2896, _e2890);
} else {
phi_89130_ = type_26(_e2890, _e2896);
}
let _e2910 = phi_89130_;
if _e1001 {
phi_89181_ = 0u;
} else {
if (_e784 == 1u) {
phi_89180_ = 0u;
} else {
if (_e784 == 2u) {
phi_89179_ = _e2600;
} else {
phi_89179_ = select(_e2606, _e2603, (_e784 == 3u));
}
let _e2918 = phi_89179_;
phi_89180_ = _e2918;
}
let _e2920 = phi_89180_;
phi_89181_ = _e2920;
}
let _e2922 = phi_89181_;
local_18 = (((bitcast<i32>(_e2922) + _e2910.member_1) * _e2597) + _e2910.member);
let _e2927 = local_18;
let _e2929 = select(_e2623, _e2927, (_e2927 < _e2623));
let _e2934 = global_6.member[bitcast<u32>(select(0i, _e2929, (_e2929 > 0i)))];
let _e2939 = (((((select(_e2900, _e2904, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e2944 = ((1f - (((select(_e2904, _e2900, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e2951 = ((_e2160.member * _e2939) + (_e2168.member * _e2944));
let _e2952 = ((_e2160.member_1 * _e2939) + (_e2168.member_1 * _e2944));
let _e2953 = ((_e2160.member_2 * _e2939) + (_e2168.member_2 * _e2944));
let _e2957 = select((_e2183.member + _e2951), _e2183.member, _e2181);
let _e2958 = select((_e2183.member_1 + _e2952), _e2183.member_1, _e2181);
let _e2959 = select((_e2183.member_2 + _e2953), _e2183.member_2, _e2181);
let _e2970 = (((_e2957 * _e2957) + (_e2958 * _e2958)) + (_e2959 * _e2959));
let _e2974 = (1f / sqrt(select(0f, _e2970, (_e2970 > 0f))));
let _e2975 = (_e2957 * _e2974);
let _e2976 = (_e2958 * _e2974);
let _e2977 = (_e2959 * _e2974);
let _e2978 = (_e593 - select(_e2194.member, (_e2194.member + _e2951), _e2181));
let _e2979 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e2952), _e2181));
let _e2980 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e2953), _e2181));
let _e2985 = (((_e2978 * _e2975) + (_e2979 * _e2976)) + (_e2980 * _e2977));
let _e2990 = (((_e2978 * _e631) + (_e2979 * _e644)) + (_e2980 * _e657));
let _e2995 = (((_e2975 * _e631) + (_e2976 * _e644)) + (_e2977 * _e657));
let _e2998 = ((_e2976 * _e657) - (_e2977 * _e644));
let _e3001 = ((_e2977 * _e631) - (_e2975 * _e657));
let _e3004 = ((_e2975 * _e644) - (_e2976 * _e631));
let _e3009 = (((_e2998 * _e2998) + (_e3001 * _e3001)) + (_e3004 * _e3004));
let _e3012 = (1f / select(1e-9f, _e3009, (_e3009 > 1e-9f)));
let _e3015 = ((_e2985 - (_e2995 * _e2990)) * _e3012);
let _e3018 = (((_e2995 * _e2985) - _e2990) * _e3012);
let _e3024 = select(0f, _e3015, (((_e3018 >= 0f) && (_e3018 < _e709)) && (_e3015 > 0f)));
let _e3026 = (_e2890 << bitcast<u32>(_e1002));
if _e2738 {
phi_90165_ = (_e2518.member - 1i);
} else {
phi_90165_ = _e2737;
}
let _e3041 = phi_90165_;
if _e2893 {
phi_90176_ = (_e2518.member_1 - 1i);
} else {
phi_90176_ = _e2892;
}
let _e3044 = phi_90176_;
let _e3048 = (((f32(_e3041) + 0.5f) * _e2523) - 0.5f);
let _e3052 = (((f32(_e3044) + 0.5f) * _e2523) - 0.5f);
if _e471 {
phi_90204_ = type_26(_e3044, _e3041);
} else {
phi_90204_ = type_26(_e3041, _e3044);
}
let _e3058 = phi_90204_;
if _e1001 {
phi_90255_ = 0u;
} else {
if (_e784 == 1u) {
phi_90254_ = 0u;
} else {
if (_e784 == 2u) {
phi_90253_ = _e2600;
} else {
phi_90253_ = select(_e2606, _e2603, (_e784 == 3u));
}
let _e3066 = phi_90253_;
phi_90254_ = _e3066;
}
let _e3068 = phi_90254_;
phi_90255_ = _e3068;
}
let _e3070 = phi_90255_;
local_16 = (((bitcast<i32>(_e3070) + _e3058.member_1) * _e2597) + _e3058.member);
let _e3075 = local_16;
let _e3077 = select(_e2623, _e3075, (_e3075 < _e2623));
let _e3082 = global_6.member[bitcast<u32>(select(0i, _e3077, (_e3077 > 0i)))];
let _e3087 = (((((select(_e3048, _e3052, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e3092 = ((1f - (((select(_e3052, _e3048, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e3099 = ((_e2160.member * _e3087) + (_e2168.member * _e3092));
let _e3100 = ((_e2160.member_1 * _e3087) + (_e2168.member_1 * _e3092));
let _e3101 = ((_e2160.member_2 * _e3087) + (_e2168.member_2 * _e3092));
let _e3105 = select((_e2183.member + _e3099), _e2183.member, _e2181);
let _e3106 = select((_e2183.member_1 + _e3100), _e2183.member_1, _e2181);
let _e3107 = select((_e2183.member_2 + _e3101), _e2183.member_2, _e2181);
let _e3118 = (((_e3105 * _e3105) + (_e3106 * _e3106)) + (_e3107 * _e3107));
let _e3122 = (1f / sqrt(select(0f, _e3118, (_e3118 > 0f))));
let _e3123 = (_e3105 * _e3122);
let _e3124 = (_e3106 * _e3122);
let _e3125 = (_e3107 * _e3122);
let _e3126 = (_e593 - select(_e2194.member, (_e2194.member + _e3099), _e2181));
let _e3127 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e3100), _e2181));
let _e3128 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e3101), _e2181));
let _e3133 = (((_e3126 * _e3123) + (_e3127 * _e3124)) + (_e3128 * _e3125));
let _e3138 = (((_e3126 * _e631) + (_e3127 * _e644)) + (_e3128 * _e657));
let _e3143 = (((_e3123 * _e631) + (_e3124 * _e644)) + (_e3125 * _e657));
let _e3146 = ((_e3124 * _e657) - (_e3125 * _e644));
let _e3149 = ((_e3125 * _e631) - (_e3123 * _e657));
let _e3152 = ((_e3123 * _e644) - (_e3124 * _e631));
let _e3157 = (((_e3146 * _e3146) + (_e3149 * _e3149)) + (_e3152 * _e3152));
let _e3160 = (1f / select(1e-9f, _e3157, (_e3157 > 1e-9f)));
let _e3163 = ((_e3133 - (_e3143 * _e3138)) * _e3160);
let _e3166 = (((_e3143 * _e3133) - _e3138) * _e3160);
let _e3172 = select(0f, _e3163, (((_e3166 >= 0f) && (_e3166 < _e709)) && (_e3163 > 0f)));
let _e3174 = (_e3041 << bitcast<u32>(_e1002));
let _e3186 = select(((((1f - select(0f, (_e2563 * _e2564), (((select(select(_e784, _e941, (_e2722 >= _e710)), _e863, (_e2722 < _e316)) == _e784) && (_e2720 > 0f)) && (_e2720 < _e2630)))) - select(0f, (_e2560 * _e2564), (((select(select(_e784, _e941, (_e2874 >= _e710)), _e863, (_e2874 < _e316)) == _e784) && (_e2872 > 0f)) && (_e2872 < _e2782)))) - select(0f, (_e2563 * _e2562), (((select(select(_e784, _e941, (_e3026 >= _e710)), _e863, (_e3026 < _e316)) == _e784) && (_e3024 > 0f)) && (_e3024 < _e2934)))) - select(0f, (_e2560 * _e2562), (((select(select(_e784, _e941, (_e3174 >= _e710)), _e863, (_e3174 < _e316)) == _e784) && (_e3172 > 0f)) && (_e3172 < _e3082)))), 1f, _e1001);
let _e3187 = (_e1946 & 31u);
let _e3189 = (1u << bitcast<u32>(_e3187));
let _e3198 = bitcast<i32>((((_e946 + _e3189) - 1u) >> bitcast<u32>(_e3187)));
let _e3199 = bitcast<i32>((((_e949 + _e3189) - 1u) >> bitcast<u32>(_e3187)));
if _e471 {
phi_91257_ = type_26(_e3199, _e3198);
} else {
phi_91257_ = type_26(_e3198, _e3199);
}
let _e3203 = phi_91257_;
let _e3208 = f32((1i << bitcast<u32>(_e3187)));
let _e3209 = (1f / _e3208);
let _e3211 = ((_e1967 * _e3209) - 0.5f);
let _e3213 = ((_e2061 * _e3209) - 0.5f);
let _e3215 = select(-1f, _e3211, (_e3211 > -1f));
let _e3217 = select(1e6f, _e3215, (_e3215 < 1e6f));
let _e3224 = select(0i, select(select(i32(_e3217), i32(-2147483648), (_e3217 < -2147483600f)), 2147483647i, (_e3217 > 2147483500f)), (_e3217 == _e3217));
let _e3228 = (_e3224 - select(0i, 1i, (_e3217 < f32(_e3224))));
let _e3230 = select(-1f, _e3213, (_e3213 > -1f));
let _e3232 = select(1e6f, _e3230, (_e3230 < 1e6f));
let _e3239 = select(0i, select(select(i32(_e3232), i32(-2147483648), (_e3232 < -2147483600f)), 2147483647i, (_e3232 > 2147483500f)), (_e3232 == _e3232));
let _e3243 = (_e3239 - select(0i, 1i, (_e3232 < f32(_e3239))));
let _e3245 = (_e3211 - f32(_e3228));
let _e3247 = (_e3213 - f32(_e3243));
let _e3248 = (1f - _e3245);
let _e3249 = (1f - _e3247);
let _e3252 = select(_e3228, 0i, (_e3228 < 0i));
let _e3253 = (_e3252 >= _e3203.member);
if _e3253 {
phi_91335_ = (_e3203.member - 1i);
} else {
phi_91335_ = _e3252;
}
let _e3256 = phi_91335_;
let _e3258 = select(_e3243, 0i, (_e3243 < 0i));
let _e3259 = (_e3258 >= _e3203.member_1);
if _e3259 {
phi_91346_ = (_e3203.member_1 - 1i);
} else {
phi_91346_ = _e3258;
}
let _e3262 = phi_91346_;
let _e3266 = (((f32(_e3256) + 0.5f) * _e3208) - 0.5f);
let _e3270 = (((f32(_e3262) + 0.5f) * _e3208) - 0.5f);
if _e471 {
phi_91374_ = type_26(_e3262, _e3256);
} else {
phi_91374_ = type_26(_e3256, _e3262);
}
let _e3276 = phi_91374_;
let _e3279 = (_e1946 == 0u);
if _e3279 {
phi_91425_ = 0u;
} else {
if (_e1946 == 1u) {
phi_91424_ = 0u;
} else {
if (_e1946 == 2u) {
phi_91423_ = _e2600;
} else {
phi_91423_ = select(_e2606, _e2603, (_e1946 == 3u));
}
let _e3285 = phi_91423_;
phi_91424_ = _e3285;
}
let _e3287 = phi_91424_;
phi_91425_ = _e3287;
}
let _e3289 = phi_91425_;
local_14 = (((bitcast<i32>(_e3289) + _e3276.member_1) * _e2597) + _e3276.member);
let _e3294 = local_14;
let _e3296 = select(_e2623, _e3294, (_e3294 < _e2623));
let _e3301 = global_6.member[bitcast<u32>(select(0i, _e3296, (_e3296 > 0i)))];
let _e3306 = (((((select(_e3266, _e3270, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e3311 = ((1f - (((select(_e3270, _e3266, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e3318 = ((_e2160.member * _e3306) + (_e2168.member * _e3311));
let _e3319 = ((_e2160.member_1 * _e3306) + (_e2168.member_1 * _e3311));
let _e3320 = ((_e2160.member_2 * _e3306) + (_e2168.member_2 * _e3311));
let _e3324 = select((_e2183.member + _e3318), _e2183.member, _e2181);
let _e3325 = select((_e2183.member_1 + _e3319), _e2183.member_1, _e2181);
let _e3326 = select((_e2183.member_2 + _e3320), _e2183.member_2, _e2181);
let _e3337 = (((_e3324 * _e3324) + (_e3325 * _e3325)) + (_e3326 * _e3326));
let _e3341 = (1f / sqrt(select(0f, _e3337, (_e3337 > 0f))));
let _e3342 = (_e3324 * _e3341);
let _e3343 = (_e3325 * _e3341);
let _e3344 = (_e3326 * _e3341);
let _e3345 = (_e593 - select(_e2194.member, (_e2194.member + _e3318), _e2181));
let _e3346 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e3319), _e2181));
let _e3347 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e3320), _e2181));
let _e3352 = (((_e3345 * _e3342) + (_e3346 * _e3343)) + (_e3347 * _e3344));
let _e3357 = (((_e3345 * _e631) + (_e3346 * _e644)) + (_e3347 * _e657));
let _e3362 = (((_e3342 * _e631) + (_e3343 * _e644)) + (_e3344 * _e657));
let _e3365 = ((_e3343 * _e657) - (_e3344 * _e644));
let _e3368 = ((_e3344 * _e631) - (_e3342 * _e657));
let _e3371 = ((_e3342 * _e644) - (_e3343 * _e631));
let _e3376 = (((_e3365 * _e3365) + (_e3368 * _e3368)) + (_e3371 * _e3371));
let _e3379 = (1f / select(1e-9f, _e3376, (_e3376 > 1e-9f)));
let _e3382 = ((_e3352 - (_e3362 * _e3357)) * _e3379);
let _e3385 = (((_e3362 * _e3352) - _e3357) * _e3379);
let _e3391 = select(0f, _e3382, (((_e3385 >= 0f) && (_e3385 < _e709)) && (_e3382 > 0f)));
let _e3393 = (_e3256 << bitcast<u32>(_e3187));
let _e3405 = (_e3228 + 1i);
let _e3408 = select(_e3405, 0i, (_e3405 < 0i));
let _e3409 = (_e3408 >= _e3203.member);
if _e3409 {
phi_92409_ = (_e3203.member - 1i);
} else {
phi_92409_ = _e3408;
}
let _e3412 = phi_92409_;
if _e3259 {
phi_92420_ = (_e3203.member_1 - 1i);
} else {
phi_92420_ = _e3258;
}
let _e3415 = phi_92420_;
let _e3419 = (((f32(_e3412) + 0.5f) * _e3208) - 0.5f);
let _e3423 = (((f32(_e3415) + 0.5f) * _e3208) - 0.5f);
if _e471 {
phi_92448_ = type_26(_e3415, _e3412);
} else {
phi_92448_ = type_26(_e3412, _e3415);
}
let _e3429 = phi_92448_;
if _e3279 {
phi_92499_ = 0u;
} else {
if (_e1946 == 1u) {
phi_92498_ = 0u;
} else {
if (_e1946 == 2u) {
phi_92497_ = _e2600;
} else {
phi_92497_ = select(_e2606, _e2603, (_e1946 == 3u));
}
let _e3437 = phi_92497_;
phi_92498_ = _e3437;
}
let _e3439 = phi_92498_;
phi_92499_ = _e3439;
}
let _e3441 = phi_92499_;
local_12 = (((bitcast<i32>(_e3441) + _e3429.member_1) * _e2597) + _e3429.member);
let _e3446 = local_12;
let _e3448 = select(_e2623, _e3446, (_e3446 < _e2623));
let _e3453 = global_6.member[bitcast<u32>(select(0i, _e3448, (_e3448 > 0i)))];
let _e3458 = (((((select(_e3419, _e3423, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e3463 = ((1f - (((select(_e3423, _e3419, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e3470 = ((_e2160.member * _e3458) + (_e2168.member * _e3463));
let _e3471 = ((_e2160.member_1 * _e3458) + (_e2168.member_1 * _e3463));
let _e3472 = ((_e2160.member_2 * _e3458) + (_e2168.member_2 * _e3463));
let _e3476 = select((_e2183.member + _e3470), _e2183.member, _e2181);
let _e3477 = select((_e2183.member_1 + _e3471), _e2183.member_1, _e2181);
let _e3478 = select((_e2183.member_2 + _e3472), _e2183.member_2, _e2181);
let _e3489 = (((_e3476 * _e3476) + (_e3477 * _e3477)) + (_e3478 * _e3478));
let _e3493 = (1f / sqrt(select(0f, _e3489, (_e3489 > 0f))));
let _e3494 = (_e3476 * _e3493);
let _e3495 = (_e3477 * _e3493);
let _e3496 = (_e3478 * _e3493);
let _e3497 = (_e593 - select(_e2194.member, (_e2194.member + _e3470), _e2181));
let _e3498 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e3471), _e2181));
let _e3499 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e3472), _e2181));
let _e3504 = (((_e3497 * _e3494) + (_e3498 * _e3495)) + (_e3499 * _e3496));
let _e3509 = (((_e3497 * _e631) + (_e3498 * _e644)) + (_e3499 * _e657));
let _e3514 = (((_e3494 * _e631) + (_e3495 * _e644)) + (_e3496 * _e657));
let _e3517 = ((_e3495 * _e657) - (_e3496 * _e644));
let _e3520 = ((_e3496 * _e631) - (_e3494 * _e657));
let _e3523 = ((_e3494 * _e644) - (_e3495 * _e631));
let _e3528 = (((_e3517 * _e3517) + (_e3520 * _e3520)) + (_e3523 * _e3523));
let _e3531 = (1f / select(1e-9f, _e3528, (_e3528 > 1e-9f)));
let _e3534 = ((_e3504 - (_e3514 * _e3509)) * _e3531);
let _e3537 = (((_e3514 * _e3504) - _e3509) * _e3531);
let _e3543 = select(0f, _e3534, (((_e3537 >= 0f) && (_e3537 < _e709)) && (_e3534 > 0f)));
let _e3545 = (_e3412 << bitcast<u32>(_e3187));
let _e3557 = (_e3243 + 1i);
if _e3253 {
phi_93483_ = (_e3203.member - 1i);
} else {
phi_93483_ = _e3252;
}
let _e3561 = phi_93483_;
let _e3563 = select(_e3557, 0i, (_e3557 < 0i));
let _e3564 = (_e3563 >= _e3203.member_1);
if _e3564 {
phi_93494_ = (_e3203.member_1 - 1i);
} else {
phi_93494_ = _e3563;
}
let _e3567 = phi_93494_;
let _e3571 = (((f32(_e3561) + 0.5f) * _e3208) - 0.5f);
let _e3575 = (((f32(_e3567) + 0.5f) * _e3208) - 0.5f);
if _e471 {
phi_93522_ = type_26(_e3567, _e3561);
} else {
phi_93522_ = type_26(_e3561, _e3567);
}
let _e3581 = phi_93522_;
if _e3279 {
phi_93573_ = 0u;
} else {
if (_e1946 == 1u) {
phi_93572_ = 0u;
} else {
if (_e1946 == 2u) {
phi_93571_ = _e2600;
} else {
phi_93571_ = select(_e2606, _e2603, (_e1946 == 3u));
}
let _e3589 = phi_93571_;
phi_93572_ = _e3589;
}
let _e3591 = phi_93572_;
phi_93573_ = _e3591;
}
let _e3593 = phi_93573_;
local_10 = (((bitcast<i32>(_e3593) + _e3581.member_1) * _e2597) + _e3581.member);
let _e3598 = local_10;
let _e3600 = select(_e2623, _e3598, (_e3598 < _e2623));
let _e3605 = global_6.member[bitcast<u32>(select(0i, _e3600, (_e3600 > 0i)))];
let _e3610 = (((((select(_e3571, _e3575, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e3615 = ((1f - (((select(_e3575, _e3571, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e3622 = ((_e2160.member * _e3610) + (_e2168.member * _e3615));
let _e3623 = ((_e2160.member_1 * _e3610) + (_e2168.member_1 * _e3615));
let _e3624 = ((_e2160.member_2 * _e3610) + (_e2168.member_2 * _e3615));
let _e3628 = select((_e2183.member + _e3622), _e2183.member, _e2181);
let _e3629 = select((_e2183.member_1 + _e3623), _e2183.member_1, _e2181);
let _e3630 = select((_e2183.member_2 + _e3624), _e2183.member_2, _e2181);
let _e3641 = (((_e3628 * _e3628) + (_e3629 * _e3629)) + (_e3630 * _e3630));
let _e3645 = (1f / sqrt(select(0f, _e3641, (_e3641 > 0f))));
let _e3646 = (_e3628 * _e3645);
let _e3647 = (_e3629 * _e3645);
let _e3648 = (_e3630 * _e3645);
let _e3649 = (_e593 - select(_e2194.member, (_e2194.member + _e3622), _e2181));
let _e3650 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e3623), _e2181));
let _e3651 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e3624), _e2181));
let _e3656 = (((_e3649 * _e3646) + (_e3650 * _e3647)) + (_e3651 * _e3648));
let _e3661 = (((_e3649 * _e631) + (_e3650 * _e644)) + (_e3651 * _e657));
let _e3666 = (((_e3646 * _e631) + (_e3647 * _e644)) + (_e3648 * _e657));
let _e3669 = ((_e3647 * _e657) - (_e3648 * _e644));
let _e3672 = ((_e3648 * _e631) - (_e3646 * _e657));
let _e3675 = ((_e3646 * _e644) - (_e3647 * _e631));
let _e3680 = (((_e3669 * _e3669) + (_e3672 * _e3672)) + (_e3675 * _e3675));
let _e3683 = (1f / select(1e-9f, _e3680, (_e3680 > 1e-9f)));
let _e3686 = ((_e3656 - (_e3666 * _e3661)) * _e3683);
let _e3689 = (((_e3666 * _e3656) - _e3661) * _e3683);
let _e3695 = select(0f, _e3686, (((_e3689 >= 0f) && (_e3689 < _e709)) && (_e3686 > 0f)));
let _e3697 = (_e3561 << bitcast<u32>(_e3187));
if _e3409 {
phi_94557_ = (_e3203.member - 1i);
} else {
phi_94557_ = _e3408;
}
let _e3712 = phi_94557_;
if _e3564 {
phi_94568_ = (_e3203.member_1 - 1i);
} else {
phi_94568_ = _e3563;
}
let _e3715 = phi_94568_;
let _e3719 = (((f32(_e3712) + 0.5f) * _e3208) - 0.5f);
let _e3723 = (((f32(_e3715) + 0.5f) * _e3208) - 0.5f);
if _e471 {
phi_94596_ = type_26(_e3715, _e3712);
} else {
phi_94596_ = type_26(_e3712, _e3715);
}
let _e3729 = phi_94596_;
if _e3279 {
phi_94647_ = 0u;
} else {
if (_e1946 == 1u) {
phi_94646_ = 0u;
} else {
if (_e1946 == 2u) {
phi_94645_ = _e2600;
} else {
phi_94645_ = select(_e2606, _e2603, (_e1946 == 3u));
}
let _e3737 = phi_94645_;
phi_94646_ = _e3737;
}
let _e3739 = phi_94646_;
phi_94647_ = _e3739;
}
let _e3741 = phi_94647_;
local_8 = (((bitcast<i32>(_e3741) + _e3729.member_1) * _e2597) + _e3729.member);
let _e3746 = local_8;
let _e3748 = select(_e2623, _e3746, (_e3746 < _e2623));
let _e3753 = global_6.member[bitcast<u32>(select(0i, _e3748, (_e3748 > 0i)))];
let _e3758 = (((((select(_e3719, _e3723, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e3763 = ((1f - (((select(_e3723, _e3719, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e3770 = ((_e2160.member * _e3758) + (_e2168.member * _e3763));
let _e3771 = ((_e2160.member_1 * _e3758) + (_e2168.member_1 * _e3763));
let _e3772 = ((_e2160.member_2 * _e3758) + (_e2168.member_2 * _e3763));
let _e3776 = select((_e2183.member + _e3770), _e2183.member, _e2181);
let _e3777 = select((_e2183.member_1 + _e3771), _e2183.member_1, _e2181);
let _e3778 = select((_e2183.member_2 + _e3772), _e2183.member_2, _e2181);
let _e3789 = (((_e3776 * _e3776) + (_e3777 * _e3777)) + (_e3778 * _e3778));
let _e3793 = (1f / sqrt(select(0f, _e3789, (_e3789 > 0f))));
let _e3794 = (_e3776 * _e3793);
let _e3795 = (_e3777 * _e3793);
let _e3796 = (_e3778 * _e3793);
let _e3797 = (_e593 - select(_e2194.member, (_e2194.member + _e3770), _e2181));
let _e3798 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e3771), _e2181));
let _e3799 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e3772), _e2181));
let _e3804 = (((_e3797 * _e3794) + (_e3798 * _e3795)) + (_e3799 * _e3796));
let _e3809 = (((_e3797 * _e631) + (_e3798 * _e644)) + (_e3799 * _e657));
let _e3814 = (((_e3794 * _e631) + (_e3795 * _e644)) + (_e3796 * _e657));
let _e3817 = ((_e3795 * _e657) - (_e3796 * _e644));
let _e3820 = ((_e3796 * _e631) - (_e3794 * _e657));
let _e3823 = ((_e3794 * _e644) - (_e3795 * _e631));
let _e3828 = (((_e3817 * _e3817) + (_e3820 * _e3820)) + (_e3823 * _e3823));
let _e3831 = (1f / select(1e-9f, _e3828, (_e3828 > 1e-9f)));
let _e3834 = ((_e3804 - (_e3814 * _e3809)) * _e3831);
let _e3837 = (((_e3814 * _e3804) - _e3809) * _e3831);
let _e3843 = select(0f, _e3834, (((_e3837 >= 0f) && (_e3837 < _e709)) && (_e3834 > 0f)));
let _e3845 = (_e3712 << bitcast<u32>(_e3187));
let _e3857 = select(((((_e3186 - select(0f, (_e3248 * _e3249), (((select(select(_e784, _e941, (_e3393 >= _e710)), _e863, (_e3393 < _e316)) == _e1946) && (_e3391 > 0f)) && (_e3391 < _e3301)))) - select(0f, (_e3245 * _e3249), (((select(select(_e784, _e941, (_e3545 >= _e710)), _e863, (_e3545 < _e316)) == _e1946) && (_e3543 > 0f)) && (_e3543 < _e3453)))) - select(0f, (_e3248 * _e3247), (((select(select(_e784, _e941, (_e3697 >= _e710)), _e863, (_e3697 < _e316)) == _e1946) && (_e3695 > 0f)) && (_e3695 < _e3605)))) - select(0f, (_e3245 * _e3247), (((select(select(_e784, _e941, (_e3845 >= _e710)), _e863, (_e3845 < _e316)) == _e1946) && (_e3843 > 0f)) && (_e3843 < _e3753)))), _e3186, _e3279);
let _e3858 = (_e1950 & 31u);
let _e3860 = (1u << bitcast<u32>(_e3858));
let _e3869 = bitcast<i32>((((_e946 + _e3860) - 1u) >> bitcast<u32>(_e3858)));
let _e3870 = bitcast<i32>((((_e949 + _e3860) - 1u) >> bitcast<u32>(_e3858)));
if _e471 {
phi_95649_ = type_26(_e3870, _e3869);
} else {
phi_95649_ = type_26(_e3869, _e3870);
}
let _e3874 = phi_95649_;
let _e3879 = f32((1i << bitcast<u32>(_e3858)));
let _e3880 = (1f / _e3879);
let _e3882 = ((_e1967 * _e3880) - 0.5f);
let _e3884 = ((_e2061 * _e3880) - 0.5f);
let _e3886 = select(-1f, _e3882, (_e3882 > -1f));
let _e3888 = select(1e6f, _e3886, (_e3886 < 1e6f));
let _e3895 = select(0i, select(select(i32(_e3888), i32(-2147483648), (_e3888 < -2147483600f)), 2147483647i, (_e3888 > 2147483500f)), (_e3888 == _e3888));
let _e3899 = (_e3895 - select(0i, 1i, (_e3888 < f32(_e3895))));
let _e3901 = select(-1f, _e3884, (_e3884 > -1f));
let _e3903 = select(1e6f, _e3901, (_e3901 < 1e6f));
let _e3910 = select(0i, select(select(i32(_e3903), i32(-2147483648), (_e3903 < -2147483600f)), 2147483647i, (_e3903 > 2147483500f)), (_e3903 == _e3903));
let _e3914 = (_e3910 - select(0i, 1i, (_e3903 < f32(_e3910))));
let _e3916 = (_e3882 - f32(_e3899));
let _e3918 = (_e3884 - f32(_e3914));
let _e3919 = (1f - _e3916);
let _e3920 = (1f - _e3918);
let _e3923 = select(_e3899, 0i, (_e3899 < 0i));
let _e3924 = (_e3923 >= _e3874.member);
if _e3924 {
phi_95727_ = (_e3874.member - 1i);
} else {
phi_95727_ = _e3923;
}
let _e3927 = phi_95727_;
let _e3929 = select(_e3914, 0i, (_e3914 < 0i));
let _e3930 = (_e3929 >= _e3874.member_1);
if _e3930 {
phi_95738_ = (_e3874.member_1 - 1i);
} else {
phi_95738_ = _e3929;
}
let _e3933 = phi_95738_;
let _e3937 = (((f32(_e3927) + 0.5f) * _e3879) - 0.5f);
let _e3941 = (((f32(_e3933) + 0.5f) * _e3879) - 0.5f);
if _e471 {
phi_95766_ = type_26(_e3933, _e3927);
} else {
phi_95766_ = type_26(_e3927, _e3933);
}
let _e3947 = phi_95766_;
let _e3950 = (_e1950 == 0u);
if _e3950 {
phi_95817_ = 0u;
} else {
if (_e1950 == 1u) {
phi_95816_ = 0u;
} else {
if (_e1950 == 2u) {
phi_95815_ = _e2600;
} else {
phi_95815_ = select(_e2606, _e2603, (_e1950 == 3u));
}
let _e3956 = phi_95815_;
phi_95816_ = _e3956;
}
let _e3958 = phi_95816_;
phi_95817_ = _e3958;
}
let _e3960 = phi_95817_;
local_6 = (((bitcast<i32>(_e3960) + _e3947.member_1) * _e2597) + _e3947.member);
let _e3965 = local_6;
let _e3967 = select(_e2623, _e3965, (_e3965 < _e2623));
let _e3972 = global_6.member[bitcast<u32>(select(0i, _e3967, (_e3967 > 0i)))];
let _e3977 = (((((select(_e3937, _e3941, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e3982 = ((1f - (((select(_e3941, _e3937, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e3989 = ((_e2160.member * _e3977) + (_e2168.member * _e3982));
let _e3990 = ((_e2160.member_1 * _e3977) + (_e2168.member_1 * _e3982));
let _e3991 = ((_e2160.member_2 * _e3977) + (_e2168.member_2 * _e3982));
let _e3995 = select((_e2183.member + _e3989), _e2183.member, _e2181);
let _e3996 = select((_e2183.member_1 + _e3990), _e2183.member_1, _e2181);
let _e3997 = select((_e2183.member_2 + _e3991), _e2183.member_2, _e2181);
let _e4008 = (((_e3995 * _e3995) + (_e3996 * _e3996)) + (_e3997 * _e3997));
let _e4012 = (1f / sqrt(select(0f, _e4008, (_e4008 > 0f))));
let _e4013 = (_e3995 * _e4012);
let _e4014 = (_e3996 * _e4012);
let _e4015 = (_e3997 * _e4012);
let _e4016 = (_e593 - select(_e2194.member, (_e2194.member + _e3989), _e2181));
let _e4017 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e3990), _e2181));
let _e4018 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e3991), _e2181));
let _e4023 = (((_e4016 * _e4013) + (_e4017 * _e4014)) + (_e4018 * _e4015));
let _e4028 = (((_e4016 * _e631) + (_e4017 * _e644)) + (_e4018 * _e657));
let _e4033 = (((_e4013 * _e631) + (_e4014 * _e644)) + (_e4015 * _e657));
let _e4036 = ((_e4014 * _e657) - (_e4015 * _e644));
let _e4039 = ((_e4015 * _e631) - (_e4013 * _e657));
let _e4042 = ((_e4013 * _e644) - (_e4014 * _e631));
let _e4047 = (((_e4036 * _e4036) + (_e4039 * _e4039)) + (_e4042 * _e4042));
let _e4050 = (1f / select(1e-9f, _e4047, (_e4047 > 1e-9f)));
let _e4053 = ((_e4023 - (_e4033 * _e4028)) * _e4050);
let _e4056 = (((_e4033 * _e4023) - _e4028) * _e4050);
let _e4062 = select(0f, _e4053, (((_e4056 >= 0f) && (_e4056 < _e709)) && (_e4053 > 0f)));
let _e4064 = (_e3927 << bitcast<u32>(_e3858));
let _e4076 = (_e3899 + 1i);
let _e4079 = select(_e4076, 0i, (_e4076 < 0i));
let _e4080 = (_e4079 >= _e3874.member);
if _e4080 {
phi_96801_ = (_e3874.member - 1i);
} else {
phi_96801_ = _e4079;
}
let _e4083 = phi_96801_;
if _e3930 {
phi_96812_ = (_e3874.member_1 - 1i);
} else {
phi_96812_ = _e3929;
}
let _e4086 = phi_96812_;
let _e4090 = (((f32(_e4083) + 0.5f) * _e3879) - 0.5f);
let _e4094 = (((f32(_e4086) + 0.5f) * _e3879) - 0.5f);
if _e471 {
phi_96840_ = type_26(_e4086, _e4083);
} else {
phi_96840_ = type_26(_e4083, _e4086);
}
let _e4100 = phi_96840_;
if _e3950 {
phi_96891_ = 0u;
} else {
if (_e1950 == 1u) {
phi_96890_ = 0u;
} else {
if (_e1950 == 2u) {
phi_96889_ = _e2600;
} else {
phi_96889_ = select(_e2606, _e2603, (_e1950 == 3u));
}
let _e4108 = phi_96889_;
phi_96890_ = _e4108;
}
let _e4110 = phi_96890_;
phi_96891_ = _e4110;
}
let _e4112 = phi_96891_;
local_4 = (((bitcast<i32>(_e4112) + _e4100.member_1) * _e2597) + _e4100.member);
let _e4117 = local_4;
let _e4119 = select(_e2623, _e4117, (_e4117 < _e2623));
let _e4124 = global_6.member[bitcast<u32>(select(0i, _e4119, (_e4119 > 0i)))];
let _e4129 = (((((select(_e4090, _e4094, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e4134 = ((1f - (((select(_e4094, _e4090, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e4141 = ((_e2160.member * _e4129) + (_e2168.member * _e4134));
let _e4142 = ((_e2160.member_1 * _e4129) + (_e2168.member_1 * _e4134));
let _e4143 = ((_e2160.member_2 * _e4129) + (_e2168.member_2 * _e4134));
let _e4147 = select((_e2183.member + _e4141), _e2183.member, _e2181);
let _e4148 = select((_e2183.member_1 + _e4142), _e2183.member_1, _e2181);
let _e4149 = select((_e2183.member_2 + _e4143), _e2183.member_2, _e2181);
let _e4160 = (((_e4147 * _e4147) + (_e4148 * _e4148)) + (_e4149 * _e4149));
let _e4164 = (1f / sqrt(select(0f, _e4160, (_e4160 > 0f))));
let _e4165 = (_e4147 * _e4164);
let _e4166 = (_e4148 * _e4164);
let _e4167 = (_e4149 * _e4164);
let _e4168 = (_e593 - select(_e2194.member, (_e2194.member + _e4141), _e2181));
let _e4169 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e4142), _e2181));
let _e4170 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e4143), _e2181));
let _e4175 = (((_e4168 * _e4165) + (_e4169 * _e4166)) + (_e4170 * _e4167));
let _e4180 = (((_e4168 * _e631) + (_e4169 * _e644)) + (_e4170 * _e657));
let _e4185 = (((_e4165 * _e631) + (_e4166 * _e644)) + (_e4167 * _e657));
let _e4188 = ((_e4166 * _e657) - (_e4167 * _e644));
let _e4191 = ((_e4167 * _e631) - (_e4165 * _e657));
let _e4194 = ((_e4165 * _e644) - (_e4166 * _e631));
let _e4199 = (((_e4188 * _e4188) + (_e4191 * _e4191)) + (_e4194 * _e4194));
let _e4202 = (1f / select(1e-9f, _e4199, (_e4199 > 1e-9f)));
let _e4205 = ((_e4175 - (_e4185 * _e4180)) * _e4202);
let _e4208 = (((_e4185 * _e4175) - _e4180) * _e4202);
let _e4214 = select(0f, _e4205, (((_e4208 >= 0f) && (_e4208 < _e709)) && (_e4205 > 0f)));
let _e4216 = (_e4083 << bitcast<u32>(_e3858));
let _e4228 = (_e3914 + 1i);
if _e3924 {
phi_97875_ = (_e3874.member - 1i);
} else {
phi_97875_ = _e3923;
}
let _e4232 = phi_97875_;
let _e4234 = select(_e4228, 0i, (_e4228 < 0i));
let _e4235 = (_e4234 >= _e3874.member_1);
if _e4235 {
phi_97886_ = (_e3874.member_1 - 1i);
} else {
phi_97886_ = _e4234;
}
let _e4238 = phi_97886_;
let _e4242 = (((f32(_e4232) + 0.5f) * _e3879) - 0.5f);
let _e4246 = (((f32(_e4238) + 0.5f) * _e3879) - 0.5f);
if _e471 {
phi_97914_ = type_26(_e4238, _e4232);
} else {
phi_97914_ = type_26(_e4232, _e4238);
}
let _e4252 = phi_97914_;
if _e3950 {
phi_97965_ = 0u;
} else {
if (_e1950 == 1u) {
phi_97964_ = 0u;
} else {
if (_e1950 == 2u) {
phi_97963_ = _e2600;
} else {
phi_97963_ = select(_e2606, _e2603, (_e1950 == 3u));
}
let _e4260 = phi_97963_;
phi_97964_ = _e4260;
}
let _e4262 = phi_97964_;
phi_97965_ = _e4262;
}
let _e4264 = phi_97965_;
local_2 = (((bitcast<i32>(_e4264) + _e4252.member_1) * _e2597) + _e4252.member);
let _e4269 = local_2;
let _e4271 = select(_e2623, _e4269, (_e4269 < _e2623));
let _e4276 = global_6.member[bitcast<u32>(select(0i, _e4271, (_e4271 > 0i)))];
let _e4281 = (((((select(_e4242, _e4246, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e4286 = ((1f - (((select(_e4246, _e4242, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e4293 = ((_e2160.member * _e4281) + (_e2168.member * _e4286));
let _e4294 = ((_e2160.member_1 * _e4281) + (_e2168.member_1 * _e4286));
let _e4295 = ((_e2160.member_2 * _e4281) + (_e2168.member_2 * _e4286));
let _e4299 = select((_e2183.member + _e4293), _e2183.member, _e2181);
let _e4300 = select((_e2183.member_1 + _e4294), _e2183.member_1, _e2181);
let _e4301 = select((_e2183.member_2 + _e4295), _e2183.member_2, _e2181);
let _e4312 = (((_e4299 * _e4299) + (_e4300 * _e4300)) + (_e4301 * _e4301));
let _e4316 = (1f / sqrt(select(0f, _e4312, (_e4312 > 0f))));
let _e4317 = (_e4299 * _e4316);
let _e4318 = (_e4300 * _e4316);
let _e4319 = (_e4301 * _e4316);
let _e4320 = (_e593 - select(_e2194.member, (_e2194.member + _e4293), _e2181));
let _e4321 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e4294), _e2181));
let _e4322 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e4295), _e2181));
let _e4327 = (((_e4320 * _e4317) + (_e4321 * _e4318)) + (_e4322 * _e4319));
let _e4332 = (((_e4320 * _e631) + (_e4321 * _e644)) + (_e4322 * _e657));
let _e4337 = (((_e4317 * _e631) + (_e4318 * _e644)) + (_e4319 * _e657));
let _e4340 = ((_e4318 * _e657) - (_e4319 * _e644));
let _e4343 = ((_e4319 * _e631) - (_e4317 * _e657));
let _e4346 = ((_e4317 * _e644) - (_e4318 * _e631));
let _e4351 = (((_e4340 * _e4340) + (_e4343 * _e4343)) + (_e4346 * _e4346));
let _e4354 = (1f / select(1e-9f, _e4351, (_e4351 > 1e-9f)));
let _e4357 = ((_e4327 - (_e4337 * _e4332)) * _e4354);
let _e4360 = (((_e4337 * _e4327) - _e4332) * _e4354);
let _e4366 = select(0f, _e4357, (((_e4360 >= 0f) && (_e4360 < _e709)) && (_e4357 > 0f)));
let _e4368 = (_e4232 << bitcast<u32>(_e3858));
if _e4080 {
phi_98949_ = (_e3874.member - 1i);
} else {
phi_98949_ = _e4079;
}
let _e4383 = phi_98949_;
if _e4235 {
phi_98960_ = (_e3874.member_1 - 1i);
} else {
phi_98960_ = _e4234;
}
let _e4386 = phi_98960_;
let _e4390 = (((f32(_e4383) + 0.5f) * _e3879) - 0.5f);
let _e4394 = (((f32(_e4386) + 0.5f) * _e3879) - 0.5f);
if _e471 {
phi_98988_ = type_26(_e4386, _e4383);
} else {
phi_98988_ = type_26(_e4383, _e4386);
}
let _e4400 = phi_98988_;
if _e3950 {
phi_99039_ = 0u;
} else {
if (_e1950 == 1u) {
phi_99038_ = 0u;
} else {
if (_e1950 == 2u) {
phi_99037_ = _e2600;
} else {
phi_99037_ = select(_e2606, _e2603, (_e1950 == 3u));
}
let _e4408 = phi_99037_;
phi_99038_ = _e4408;
}
let _e4410 = phi_99038_;
phi_99039_ = _e4410;
}
let _e4412 = phi_99039_;
local = (((bitcast<i32>(_e4412) + _e4400.member_1) * _e2597) + _e4400.member);
let _e4417 = local;
let _e4419 = select(_e2623, _e4417, (_e4417 < _e2623));
let _e4424 = global_6.member[bitcast<u32>(select(0i, _e4419, (_e4419 > 0i)))];
let _e4429 = (((((select(_e4390, _e4394, _e471) + 0.5f) / _e2141) * 2f) - 1f) * _e2149);
let _e4434 = ((1f - (((select(_e4394, _e4390, _e471) + 0.5f) / _e2142) * 2f)) * _e2157);
let _e4441 = ((_e2160.member * _e4429) + (_e2168.member * _e4434));
let _e4442 = ((_e2160.member_1 * _e4429) + (_e2168.member_1 * _e4434));
let _e4443 = ((_e2160.member_2 * _e4429) + (_e2168.member_2 * _e4434));
let _e4447 = select((_e2183.member + _e4441), _e2183.member, _e2181);
let _e4448 = select((_e2183.member_1 + _e4442), _e2183.member_1, _e2181);
let _e4449 = select((_e2183.member_2 + _e4443), _e2183.member_2, _e2181);
let _e4460 = (((_e4447 * _e4447) + (_e4448 * _e4448)) + (_e4449 * _e4449));
let _e4464 = (1f / sqrt(select(0f, _e4460, (_e4460 > 0f))));
let _e4465 = (_e4447 * _e4464);
let _e4466 = (_e4448 * _e4464);
let _e4467 = (_e4449 * _e4464);
let _e4468 = (_e593 - select(_e2194.member, (_e2194.member + _e4441), _e2181));
let _e4469 = (_e605 - select(_e2194.member_1, (_e2194.member_1 + _e4442), _e2181));
let _e4470 = (_e618 - select(_e2194.member_2, (_e2194.member_2 + _e4443), _e2181));
let _e4475 = (((_e4468 * _e4465) + (_e4469 * _e4466)) + (_e4470 * _e4467));
let _e4480 = (((_e4468 * _e631) + (_e4469 * _e644)) + (_e4470 * _e657));
let _e4485 = (((_e4465 * _e631) + (_e4466 * _e644)) + (_e4467 * _e657));
let _e4488 = ((_e4466 * _e657) - (_e4467 * _e644));
let _e4491 = ((_e4467 * _e631) - (_e4465 * _e657));
let _e4494 = ((_e4465 * _e644) - (_e4466 * _e631));
let _e4499 = (((_e4488 * _e4488) + (_e4491 * _e4491)) + (_e4494 * _e4494));
let _e4502 = (1f / select(1e-9f, _e4499, (_e4499 > 1e-9f)));
let _e4505 = ((_e4475 - (_e4485 * _e4480)) * _e4502);
let _e4508 = (((_e4485 * _e4475) - _e4480) * _e4502);
let _e4514 = select(0f, _e4505, (((_e4508 >= 0f) && (_e4508 < _e709)) && (_e4505 > 0f)));
let _e4516 = (_e4383 << bitcast<u32>(_e3858));
let _e4528 = select(((((_e3857 - select(0f, (_e3919 * _e3920), (((select(select(_e784, _e941, (_e4064 >= _e710)), _e863, (_e4064 < _e316)) == _e1950) && (_e4062 > 0f)) && (_e4062 < _e3972)))) - select(0f, (_e3916 * _e3920), (((select(select(_e784, _e941, (_e4216 >= _e710)), _e863, (_e4216 < _e316)) == _e1950) && (_e4214 > 0f)) && (_e4214 < _e4124)))) - select(0f, (_e3919 * _e3918), (((select(select(_e784, _e941, (_e4368 >= _e710)), _e863, (_e4368 < _e316)) == _e1950) && (_e4366 > 0f)) && (_e4366 < _e4276)))) - select(0f, (_e3916 * _e3918), (((select(select(_e784, _e941, (_e4516 >= _e710)), _e863, (_e4516 < _e316)) == _e1950) && (_e4514 > 0f)) && (_e4514 < _e4424)))), _e3857, _e3950);
if _e471 {
phi_100032_ = type_26(_e2058, _e1965);
} else {
phi_100032_ = type_26(_e1965, _e2058);
}
let _e4543 = phi_100032_;
let _e4546 = (_e2059 && (((_e2514 > 0f) && (_e2514 < _e2138)) && (bitcast<f32>((bitcast<u32>(_e4528) & 2147483647u)) > 1e-6f)));
let _e4549 = global_1.member.member_18.member;
let _e4550 = (((select(_e2084, (1f - _e2084), (_e2069 >= 0f)) - select(_e2103, (1f - _e2103), (_e2088 >= 0f))) * (1f / _e2066)) * _e4549);
let _e4554 = select(0f, (((((_e670 * _e2501.member) * ((1f + (_e2382 * (1f + (_e2382 * (0.5f + (_e2382 * (0.16666667f + (_e2382 * (0.041666668f + (_e2382 * (0.008333334f + (_e2382 * (0.001388889f + (_e2382 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2377 + 127i)) << bitcast<u32>(23i))))) * _e2344) * _e4528) * _e4550), _e4546);
let _e4555 = select(0f, (((((_e683 * _e2501.member_1) * ((1f + (_e2430 * (1f + (_e2430 * (0.5f + (_e2430 * (0.16666667f + (_e2430 * (0.041666668f + (_e2430 * (0.008333334f + (_e2430 * (0.001388889f + (_e2430 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2425 + 127i)) << bitcast<u32>(23i))))) * _e2344) * _e4528) * _e4550), _e4546);
let _e4556 = select(0f, (((((_e696 * _e2501.member_2) * ((1f + (_e2478 * (1f + (_e2478 * (0.5f + (_e2478 * (0.16666667f + (_e2478 * (0.041666668f + (_e2478 * (0.008333334f + (_e2478 * (0.001388889f + (_e2478 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2473 + 127i)) << bitcast<u32>(23i))))) * _e2344) * _e4528) * _e4550), _e4546);
let _e4560 = (bitcast<f32>((bitcast<u32>(_e4554) & 2147483647u)) >= 1073741800f);
let _e4561 = (1f / 1048576f);
let _e4564 = ((_e4554 * select(1f, _e4561, _e4560)) + 0.5f);
let _e4566 = select(-1073741800f, _e4564, (_e4564 > -1073741800f));
let _e4568 = select(1073741800f, _e4566, (_e4566 < 1073741800f));
let _e4575 = select(0i, select(select(i32(_e4568), i32(-2147483648), (_e4568 < -2147483600f)), 2147483647i, (_e4568 > 2147483500f)), (_e4568 == _e4568));
let _e4579 = (_e4575 - select(0i, 1i, (_e4568 < f32(_e4575))));
let _e4580 = select(0i, 20i, _e4560);
let _e4584 = (bitcast<u32>(_e4579) << bitcast<u32>((_e4580 & 31i)));
let _e4591 = bitcast<u32>(((_e4579 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e4580) & 31i))));
let _e4595 = (bitcast<f32>((bitcast<u32>(_e4555) & 2147483647u)) >= 1073741800f);
let _e4598 = ((_e4555 * select(1f, _e4561, _e4595)) + 0.5f);
let _e4600 = select(-1073741800f, _e4598, (_e4598 > -1073741800f));
let _e4602 = select(1073741800f, _e4600, (_e4600 < 1073741800f));
let _e4609 = select(0i, select(select(i32(_e4602), i32(-2147483648), (_e4602 < -2147483600f)), 2147483647i, (_e4602 > 2147483500f)), (_e4602 == _e4602));
let _e4613 = (_e4609 - select(0i, 1i, (_e4602 < f32(_e4609))));
let _e4614 = select(0i, 20i, _e4595);
let _e4618 = (bitcast<u32>(_e4613) << bitcast<u32>((_e4614 & 31i)));
let _e4625 = bitcast<u32>(((_e4613 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e4614) & 31i))));
let _e4629 = (bitcast<f32>((bitcast<u32>(_e4556) & 2147483647u)) >= 1073741800f);
let _e4632 = ((_e4556 * select(1f, _e4561, _e4629)) + 0.5f);
let _e4634 = select(-1073741800f, _e4632, (_e4632 > -1073741800f));
let _e4636 = select(1073741800f, _e4634, (_e4634 < 1073741800f));
let _e4643 = select(0i, select(select(i32(_e4636), i32(-2147483648), (_e4636 < -2147483600f)), 2147483647i, (_e4636 > 2147483500f)), (_e4636 == _e4636));
let _e4647 = (_e4643 - select(0i, 1i, (_e4636 < f32(_e4643))));
let _e4648 = select(0i, 20i, _e4629);
let _e4652 = (bitcast<u32>(_e4647) << bitcast<u32>((_e4648 & 31i)));
let _e4659 = bitcast<u32>(((_e4647 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e4648) & 31i))));
let _e4664 = bitcast<i32>(bitcast<u32>((((_e4543.member_1 * _e950) + _e4543.member) * 6i)));
if ((_e4584 | _e4591) == 0u) {
} else {
let _e4667 = bitcast<u32>(_e4664);
if (_e4667 < _e288) {
let _e4671 = atomicAdd((&global_8.member[_e4667]), _e4584);
phi_100265_ = _e4671;
} else {
phi_100265_ = 0u;
}
let _e4673 = phi_100265_;
let _e4677 = (_e4591 + select(0u, 1u, ((_e4673 + _e4584) < _e4584)));
if (_e4677 == 0u) {
} else {
let _e4679 = (_e4667 + 1u);
if (_e4679 < _e288) {
let _e4683 = atomicAdd((&global_8.member[_e4679]), _e4677);
}
}
}
if ((_e4618 | _e4625) == 0u) {
} else {
let _e4687 = bitcast<u32>((_e4664 + 2i));
if (_e4687 < _e288) {
let _e4691 = atomicAdd((&global_8.member[_e4687]), _e4618);
phi_100295_ = _e4691;
} else {
phi_100295_ = 0u;
}
let _e4693 = phi_100295_;
let _e4697 = (_e4625 + select(0u, 1u, ((_e4693 + _e4618) < _e4618)));
if (_e4697 == 0u) {
} else {
let _e4699 = (_e4687 + 1u);
if (_e4699 < _e288) {
let _e4703 = atomicAdd((&global_8.member[_e4699]), _e4697);
}
}
}
if ((_e4652 | _e4659) == 0u) {
} else {
let _e4707 = bitcast<u32>((_e4664 + 4i));
if (_e4707 < _e288) {
let _e4711 = atomicAdd((&global_8.member[_e4707]), _e4652);
phi_100325_ = _e4711;
} else {
phi_100325_ = 0u;
}
let _e4713 = phi_100325_;
let _e4717 = (_e4659 + select(0u, 1u, ((_e4713 + _e4652) < _e4652)));
if (_e4717 == 0u) {
} else {
let _e4719 = (_e4707 + 1u);
if (_e4719 < _e288) {
let _e4723 = atomicAdd((&global_8.member[_e4719]), _e4717);
}
}
}
phi_85708_ = (_e2056 + 1i);
} else {
phi_85708_ = i32();
}
let _e4726 = phi_85708_;
continue;
continuing {
phi_85707_ = _e4726;
break if !(_e2059);
}
}
phi_85554_ = (_e1962 + 1i);
} else {
phi_85554_ = i32();
}
let _e4730 = phi_85554_;
continue;
continuing {
phi_85553_ = _e4730;
break if !(_e1963);
}
}
}
}
}
}
}
}
}
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
